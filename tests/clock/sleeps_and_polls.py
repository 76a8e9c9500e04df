"""A client that sleeps, polls and waits for calls: what it prints tells its whole course."""
import select
import time

from naoqi import ALProxy

start = time.monotonic()
motion = ALProxy("ALMotion", "127.0.0.1", 9559)
memory = ALProxy("ALMemory", "127.0.0.1", 9559)


def tell(what, *values):
    print("%9.4f %s" % (time.monotonic() - start, what), *values)


motion.wakeUp()
tell("awake")
for step in range(20):
    motion.setAngles(["HeadYaw", "LShoulderPitch"], [0.02 * step, 1.0 - 0.01 * step], 0.3)
    time.sleep(0.033)
while motion.getAngles("HeadYaw", True)[0] < 0.3:
    pass
tell("head is there", motion.getAngles("HeadYaw", True))
task = motion.post.angleInterpolation("HeadYaw", [0.0], [0.7], True)
while motion.isRunning(task):
    select.select([], [], [], 0.01)
tell("posted motion is over")
motion.moveTo(0.2, 0.0, 0.1)
tell("walked", motion.getRobotPosition(True))
print(memory.getData("Device/SubDeviceList/InertialSensor/AngleX/Sensor/Value"), time.time())
