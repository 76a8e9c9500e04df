"""Watches the robot over a connection of its own while the demo's client works.

Beside what any client may ask it asks UsarSim, the simulator's own service, for the time and for
where the robot really is.
"""

import math
import threading
import time
from typing import List, NamedTuple, Tuple

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
    time: float  # s, simulated
    commanded: List[float]  # rad, by joint
    measured: List[float]
    odometry: Pose
    true: Pose
    tilt: Tuple[float, float]  # rad; torso roll and pitch by the inertial sensor
    true_tilt: Tuple[float, float]


class Recorder:
    """Samples about 20 times a second from start() to stop(), on a thread of its own."""

    def __init__(self, address: str):
        self._session = Session(address)
        self._motion = self._session.service("ALMotion")
        self._memory = self._session.service("ALMemory")
        self._sim = self._session.service("UsarSim")
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
        futures = [self._sim.time(_async=True), self._sim.floorPose(_async=True),
                   self._sim.torsoPose(_async=True),
                   self._motion.getAngles("Body", False, _async=True),
                   self._motion.getAngles("Body", True, _async=True),
                   self._motion.getRobotPosition(True, _async=True),
                   self._memory.getListData(TILT_KEYS, _async=True)]
        now, floor, torso, commanded, measured, odometry, tilt = [
            future.value(10000) for future in futures]
        return Sample(now, commanded, measured, Pose(*odometry), Pose(*floor), tuple(tilt),
                      tuple(torso[3:5]))

    def _run(self) -> None:
        due = time.monotonic()
        while not self._ending.wait(max(0.0, due - time.monotonic())):
            due += PERIOD
            try:
                self.samples.append(self.sample())
            except (RuntimeError, TimeoutError) as error:
                self.problem = str(error)
                return


def inWorld(pose: Pose, known: Pose, known_in_world: Pose) -> Pose:
    """`pose` in the world's frame, given one pose in both: odometry counts from anywhere."""
    turn = known_in_world.heading - known.heading
    dx, dy = pose.x - known.x, pose.y - known.y
    return Pose(known_in_world.x + math.cos(turn) * dx - math.sin(turn) * dy,
                known_in_world.y + math.sin(turn) * dx + math.cos(turn) * dy,
                pose.heading + turn)
