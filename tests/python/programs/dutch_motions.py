"""What becomes of a robot by the motions of the Dutch Nao Team, which are not part of this project:

    usarnaoqi run --py2 tests/python/programs/dutch_motions.py FOLDER [CALL...]

FOLDER has the motions.py of Dutchnaoteam/Development (naoqi/lib). A CALL is Python, m the Motions;
lie('back') and lie('belly') throw the robot down and leave it with the stiffness that it has, and
kick(angle) is what the team's motionHandler.kick does. Every call begins with the robot
standing in the team's pose with full stiffness. Without a CALL: all of ALL."""

import sys
import time

from naoqi import ALProxy

sys.path.insert(0, sys.argv[1])
import motions

ALL = [
    "m.walkTo(0.3, 0, 0)", "m.postWalkTo(0.2, 0, 0.5)", "m.setWalkTargetVelocity(1, 0, 0, 0.5)",
    "m.kickStraight(0.1)", "m.kickStraight(-0.1)", "m.experimentalKick(0.1)",
    "kick(0)", "kick(0.2)", "kick(0.4)", "kick(0.6)", "kick(1.1)",
    "kick(-0.01)", "kick(-0.2)", "kick(-0.4)", "kick(-0.6)", "kick(-1.1)",
    "m.kickOld(0.7)", "m.kickOld(-0.7)", "m.sideLeftKick()", "m.sideRightKick()", "m.hak()",
    "lie('belly'); m.bellyToStand()", "lie('belly'); m.standUp()",
    "lie('back'); m.backToStand()", "lie('back'); m.standUp()",
    "m.footLeft()", "m.footRight()", "m.diveLeft()", "m.diveRight()",
    "m.stance()", "m.keepNormalPose()", "m.setHead(0.5, 0.2)", "m.changeHead(0.2, 0.1)",
    "m.killKnees()", "m.kill()"]
SETTLED = 3  # [s] after a call has returned, for postWalkTo and the like

motion = ALProxy("ALMotion", "127.0.0.1", 9559)
truth = ALProxy("UsarSim", "127.0.0.1", 9559)
m = motions.Motions(motion, ALProxy("ALRobotPose", "127.0.0.1", 9559))


def lie(side):
    truth.push(60.0 if side == "belly" else -60.0, 0.0, 0.0, 0.3)
    time.sleep(3)


def kick(angle):
    roll = -0.2 if angle < 0 else 0.2
    motion.setAngles(["LAnkleRoll", "RAnkleRoll"], [roll, roll], 0.5)
    m.kick(angle)
    time.sleep(0.2)
    m.normalPose(True)


def begin():
    truth.restore("start")
    m.setFME(False)
    motion.setStiffnesses("Body", 1.0)
    m.normalPose(True)
    time.sleep(1)


def outcome():
    x, y, z, roll, pitch, _ = truth.torsoPose()
    lies = max(abs(roll), abs(pitch)) > 0.5
    return "%s: torso at %.2f %.2f, %.3f m high, leans by %.2f and %.2f" % (
        "lies" if lies else "stands", x, y, z, roll, pitch)


truth.snapshot("start")
for call in sys.argv[2:] or ALL:
    begin()
    try:
        exec(call)
        told = ""
    except Exception as error:
        told = "; %s" % str(error).strip().split("\n")[-1].strip()
    time.sleep(SETTLED)
    print("%-34s %s%s" % (call, outcome(), told))
