"""The demo's main job, as an ordinary client: client.py HOST:PORT OUTPUT_FOLDER."""

import contextlib
import math
import os
import sys
from typing import List, NamedTuple

import page
import png
from naoqi import ALProxy
from recorder import TILT_KEYS, Pose, Recorder, inWorld
from vision_definitions import kBottomCamera, kRGBColorSpace, kTopCamera, kVGA

HELLO = os.path.join(os.path.dirname(__file__), "..", "..", "examples", "motions", "hello.xar")
WALK = 0.4  # m
BALL = 1.1  # m; after the walk it lies where the bottom camera looks
WALK_TOLERANCE = 0.12  # m; more than any sound walk strays over so short a way
UPRIGHT = 0.5  # rad of torso tilt; a standing Nao leans less, a fallen one far more
TRACKING = 0.15  # rad between command and encoder of a robot that stands still

DEVICE = "Device/SubDeviceList/"
INERTIAL = ["AccX", "AccY", "AccZ", "GyrX", "GyrY"]


class Step(NamedTuple):
    name: str
    start: float  # s, simulated
    end: float


class DemoError(Exception):
    """Something is not as it should be; the text says what."""


class Demo:
    def __init__(self, address: str, folder: str):
        self._folder = folder
        self.steps: List[Step] = []
        self.figures: List[tuple] = []
        self.pictures: List[tuple] = []
        ip, port = address.rsplit(":", 1)
        self._proxy = lambda name: ALProxy(name, ip, int(port))
        self.motion, self.memory = self._proxy("ALMotion"), self._proxy("ALMemory")
        self.recorder = Recorder(address)
        self._simulator = self._proxy("UsarSim")
        self.clock = self._simulator.time  # s, simulated

    def tell(self, text: str) -> None:
        print("[%5.1f s] %s" % (self.clock(), text), flush=True)

    @contextlib.contextmanager
    def step(self, name: str):
        """Failures within are reported under this name."""
        start = self.clock()
        self.tell(name)
        try:
            yield
        except (DemoError, RuntimeError, TimeoutError, OSError) as error:
            text = " ".join(str(error).split())
            raise SystemExit("demo: the step '%s' failed: %s" % (name, text)) from None
        self.steps.append(Step(name, start, self.clock()))

    def figure(self, name: str, value: str) -> None:
        self.figures.append((name, value))
        self.tell("    %s: %s" % (name, value))

    def run(self) -> None:
        self.recorder.start()
        self.placeBall()
        self.wakeUp()
        self.goToStandInit()
        self.playHello()
        self.walk()
        self.readSensors()
        self.takePictures()
        self.speak()
        self.rest()
        self.recorder.stop()
        self.writePage()

    def placeBall(self) -> None:
        with self.step("put the ball %.1f m ahead" % BALL):  # the hand of the simulator's user
            x, y, heading = self._simulator.floorPose()
            self._simulator.placeBall(x + BALL * math.cos(heading), y + BALL * math.sin(heading),
                                      0.0)

    def wakeUp(self) -> None:
        with self.step("wake up"):
            self.motion.wakeUp()
            require(self.motion.robotIsWakeUp(), "robotIsWakeUp() says no")
            self.requireUpright()

    def goToStandInit(self) -> None:
        with self.step("go to StandInit"):
            reached = self._proxy("ALRobotPosture").goToPosture("StandInit", 0.5)
            require(reached, "goToPosture says that the posture was not reached")
            self.requireUpright()

    def playHello(self) -> None:
        with self.step("play hello.xar"):
            with open(HELLO, encoding="utf-8") as file:
                timeline = file.read()
            frames = self._proxy("ALFrameManager")
            behavior = frames.newBehavior("", timeline)
            before = self.clock()
            frames.completeBehavior(behavior)
            require(self.clock() - before > 1, "the 6 s timeline ended at once")
            self.requireUpright()

    def walk(self) -> None:
        with self.step("walk %.1f m ahead" % WALK):
            before = self.recorder.sample()
            self.motion.moveTo(WALK, 0.0, 0.0)
            after = self.recorder.sample()
            self.requireUpright()
            true = relative(after.true, before.true)
            odometry = relative(after.odometry, before.odometry)
            self.figure("asked for", "%.3f m ahead" % WALK)
            self.figure("really went", describe(true))
            self.figure("odometry says", describe(odometry))
            self.figure("odometry is off by", "%.1f cm, %.1f deg" % (
                100 * math.hypot(true.x - odometry.x, true.y - odometry.y),
                math.degrees(abs(wrap(true.heading - odometry.heading)))))
            require(math.hypot(true.x - WALK, true.y) < WALK_TOLERANCE,
                    "the robot is not where it was sent")

    def readSensors(self) -> None:
        with self.step("read joints and inertial sensors from ALMemory"):
            names = self.recorder.joints
            keys = [DEVICE + "%s/Position/%s/Value" % (device(name), kind)
                    for kind in ("Actuator", "Sensor") for name in names]
            values = self.memory.getListData(keys)
            commanded, measured = values[:len(names)], values[len(names):]
            errors = [abs(a - b) for a, b in zip(commanded, measured)]
            worst = max(range(len(names)), key=errors.__getitem__)
            self.figure("largest joint error, standing", "%.2f deg (%s, of %d joints)" % (
                math.degrees(errors[worst]), names[worst], len(names)))
            require(errors[worst] < TRACKING, "%s is far from its command" % names[worst])
            self.readInertial()

    def readInertial(self) -> None:
        keys = [DEVICE + "InertialSensor/%s/Sensor/Value" % name for name in INERTIAL]
        values = self.memory.getListData(keys + TILT_KEYS)
        self.figure("accelerometer", "%.2f, %.2f, %.2f m/s²" % tuple(values[:3]))
        self.figure("gyrometer x, y", "%.3f, %.3f rad/s" % tuple(values[3:5]))
        self.figure("torso roll, pitch", "%.2f, %.2f deg" % tuple(map(math.degrees, values[5:])))
        length = math.sqrt(sum(value * value for value in values[:3]))
        require(abs(length - 9.81) < 2, "the accelerometer measures %.1f m/s², not gravity" % length)

    def takePictures(self) -> None:
        with self.step("take a picture with each camera"):
            video = self._proxy("ALVideoDevice")
            for name, camera in (("top", kTopCamera), ("bottom", kBottomCamera)):
                handle = video.subscribeCamera("demo_" + name, camera, kVGA, kRGBColorSpace, 10)
                try:
                    image = video.getImageRemote(handle)
                    require(image, "the %s camera gave no image" % name)
                    self.savePicture(name, image)
                    video.releaseImage(handle)
                finally:
                    video.unsubscribe(handle)

    def savePicture(self, name: str, image: list) -> None:
        width, height, pixels = image[0], image[1], bytes(image[6])
        require(any(pixels), "the %s camera's image is black" % name)
        file_name = os.path.join(self._folder, name + ".png")
        data = png.toPng(width, height, pixels)
        with open(file_name, "wb") as file:
            file.write(data)
        self.pictures.append((name + " camera, %d x %d" % (width, height), data))
        self.tell("    %s, %d x %d" % (file_name, width, height))

    def speak(self) -> None:
        with self.step("speak"):
            self._proxy("ALTextToSpeech").say("Hello, I am a simulated Nao.")

    def rest(self) -> None:
        with self.step("rest"):
            self.motion.rest()
            require(not self.motion.robotIsWakeUp(), "robotIsWakeUp() still says yes")
            self.requireUpright()

    def requireUpright(self) -> None:
        """By the robot's own inertial sensor, as any client could."""
        roll, pitch = self.memory.getListData(TILT_KEYS)
        require(max(abs(roll), abs(pitch)) < UPRIGHT, "the robot fell (roll %.0f deg, pitch %.0f "
                "deg)" % (math.degrees(roll), math.degrees(pitch)))

    def writePage(self) -> None:
        with self.step("write demo.html"):
            samples = self.recorder.samples
            require(not self.recorder.problem, "sampling ended: " + self.recorder.problem)
            require(len(samples) > 100, "only %d samples were recorded" % len(samples))
            first, last = samples[0], samples[-1]
            end = inWorld(last.odometry, first.odometry, first.true)
            self.figure("ended at, really", describe(last.true))
            self.figure("ended at, by odometry", describe(end))
            file_name = os.path.join(self._folder, "demo.html")
            with open(file_name, "w", encoding="utf-8") as file:
                file.write(page.toHtml(self.recorder.joints, samples, self.steps, self.figures,
                                       self.pictures))
            self.tell("    %s" % file_name)


def require(condition, text: str) -> None:
    if not condition:
        raise DemoError(text)


def device(joint: str) -> str:
    """The two hip yaw-pitch joints are one device."""
    return "LHipYawPitch" if joint == "RHipYawPitch" else joint


def wrap(angle: float) -> float:
    return math.remainder(angle, 2 * math.pi)


def relative(pose: Pose, origin: Pose) -> Pose:
    """`pose` as seen from `origin`: x ahead, y to the left."""
    return inWorld(pose, origin, Pose(0, 0, 0))


def describe(pose: Pose) -> str:
    return "x %.3f m, y %.3f m, heading %.1f deg" % (
        round(pose.x, 3) + 0.0, round(pose.y, 3) + 0.0,  # adding 0 makes -0 a plain 0
        round(math.degrees(wrap(pose.heading)), 1) + 0.0)


if __name__ == "__main__":
    try:
        Demo(sys.argv[1], sys.argv[2]).run()
    except RuntimeError as problem:
        raise SystemExit("demo: %s" % " ".join(str(problem).split()))
