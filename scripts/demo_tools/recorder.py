"""Watches the robot over a connection of its own while the demo's client works."""

import math
import threading
import time
from typing import List, NamedTuple, Sequence, Tuple

from usarnaoqi_sdk import Session

PERIOD = 0.05  # s

TILT_KEYS = ["Device/SubDeviceList/InertialSensor/AngleX/Sensor/Value",
             "Device/SubDeviceList/InertialSensor/AngleY/Sensor/Value"]


class Pose(NamedTuple):
    """A place on the ground."""

    x: float  # m
    y: float  # m
    heading: float  # rad


class Sample(NamedTuple):
    time: float  # s since the demo's start
    commanded: List[float]  # rad, by joint
    measured: List[float]
    odometry: Pose
    true: Pose
    tilt: Tuple[float, float]  # rad; roll and pitch by the inertial sensor


class Recorder:
    """Samples about 20 times a second from start() to stop(), on a thread of its own."""

    def __init__(self, address: str, clock):
        self._session = Session(address)
        self._motion = self._session.service("ALMotion")
        self._memory = self._session.service("ALMemory")
        self._sim = self._session.service("UsarSim")
        self._clock = clock
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self.joints: List[str] = self._motion.getBodyNames("Body")
        self.samples: List[Sample] = []
        self.problem = ""  # why sampling ended early, if it did

    def start(self) -> None:
        self._thread.start()

    def stop(self) -> None:
        self._ending.set()
        self._thread.join()
        self._session.close()

    def sample(self) -> Sample:
        """How things stand now. The questions go out together, so the answers agree in time."""
        now = self._clock()
        futures = [self._motion.getAngles("Body", False, _async=True),
                   self._motion.getAngles("Body", True, _async=True),
                   self._motion.getRobotPosition(True, _async=True),
                   self._memory.getListData(TILT_KEYS, _async=True),
                   askTruth(self._sim)]
        commanded, measured, odometry, tilt, truth = [future.value(10) for future in futures]
        return Sample(now, commanded, measured, Pose(*odometry), toPose(truth), tuple(tilt))

    def _run(self) -> None:
        due = time.monotonic()
        while not self._ending.wait(max(0.0, due - time.monotonic())):
            due += PERIOD
            try:
                self.samples.append(self.sample())
            except (RuntimeError, TimeoutError) as error:
                self.problem = str(error)
                return


def askTruth(sim):
    """Asks the simulator, in a Future, where the robot really is: what no robot could know."""
    return sim.truePose(_async=True)


def toPose(truth: Sequence[float]) -> Pose:
    """The place on the ground of x, y, z, roll, pitch, yaw."""
    return Pose(truth[0], truth[1], truth[5])


def inWorld(pose: Pose, known: Pose, known_in_world: Pose) -> Pose:
    """`pose` in the world's frame, given one pose in both: odometry counts from anywhere."""
    turn = known_in_world.heading - known.heading
    dx, dy = pose.x - known.x, pose.y - known.y
    return Pose(known_in_world.x + math.cos(turn) * dx - math.sin(turn) * dy,
                known_in_world.y + math.sin(turn) * dx + math.cos(turn) * dy,
                pose.heading + turn)
