"""A simulated world of one's own, for tests: starts, goes on only as far as it is told, ends.

Nothing here depends on the wall's clock: time passes in step(), runUntil() and do(), simulated."""

import math
import os
import shutil
import subprocess
import tempfile
import threading
from typing import Any, Callable, List, Optional, Sequence

from .session import Session

BEAT = 0.01  # s simulated, between two looks of runUntil() and do()
FALLEN = math.radians(60)


def findProgram() -> str:
    """The simulator: the environment's USARNAOQI, else `usarnaoqi` of the PATH."""
    program = os.environ.get("USARNAOQI") or shutil.which("usarnaoqi")
    if not program:
        raise RuntimeError("there is no usarnaoqi in PATH, and USARNAOQI does not name it")
    return program


class RobotView:
    """One robot of a world: its services as any program sees them, and the truth about it."""

    def __init__(self, world: "World", name: str, address: str):
        self.name = name
        self.address = address
        self._world = world
        self._session = Session("tcp://" + address)
        self.simulator = self.service("UsarSim")

    def service(self, name: str) -> Any:
        return self._session.service(name)

    def memory(self, key: str) -> Any:
        """What ALMemory holds under a key."""
        return self.service("ALMemory").call("getData", key)

    def angle(self, joint: str) -> float:
        """What a joint's encoder reports [rad]."""
        return self.service("ALMotion").call("getAngles", joint, True)[0]

    def floorPose(self) -> List[float]:
        """Where it really stands: x, y [m], heading [rad]."""
        return self.simulator.call("floorPose")

    def tilt(self) -> float:
        """Of the torso from upright [rad], the truth."""
        _, _, _, roll, pitch, _ = self.simulator.call("torsoPose")
        return math.acos(max(-1.0, min(1.0, math.cos(roll) * math.cos(pitch))))

    def push(self, force: Sequence[float], seconds: float) -> None:
        """Pushes the torso [N], in the world's axes, from now on."""
        self._world.ask(self.simulator, "push", *map(float, force), float(seconds))

    def press(self, sensor: str, seconds: float) -> None:
        """A finger on a bumper, tactile sensor or button: "Head/Touch/Front"."""
        self._world.ask(self.simulator, "press", sensor, float(seconds))

    def do(self, service: str, method: str, *arguments: Any, within: float = 60.0) -> Any:
        """Calls a method and lets time pass until it has been answered, `within` s at most."""
        answer = self.service(service).callAsync(method, *arguments)
        self._world.runUntil(answer.isFinished, within, "%s.%s did not end" % (service, method))
        return answer.value()

    def assertUpright(self) -> None:
        tilt = self.tilt()
        assert tilt < FALLEN, "%s has fallen at %.2f s: its torso tilts by %.0f degrees" % (
            self.name, self._world.time(), math.degrees(tilt))

    def assertAt(self, x: float, y: float, within: float) -> None:
        """On the floor, `within` m of a place."""
        here = self.floorPose()
        away = math.hypot(here[0] - x, here[1] - y)
        assert away <= within, "%s is at (%.3f, %.3f) at %.2f s, %.3f m from (%.3f, %.3f)" % (
            self.name, here[0], here[1], self._world.time(), away, x, y)

    def assertAngle(self, joint: str, angle: float, within: float) -> None:
        """A joint's encoder reports an angle [rad]."""
        found = self.angle(joint)
        assert abs(found - angle) <= within, "%s of %s is at %.3f rad at %.2f s, not %.3f" % (
            joint, self.name, found, self._world.time(), angle)

    def close(self) -> None:
        self._session.close()


class World:
    """A simulator of one's own on free ports. Time stands until it is told to pass.

    `robots` are models, or "NAME=MODEL"; `world` is a file or a shipped one's name."""

    def __init__(self, robots: Sequence[str] = ("nao_h21_v33",), world: str = "", seed: int = 0,
                 options: Sequence[str] = (), program: Optional[str] = None):
        command = [program or findProgram(), "serve", "--port", "0", "--paused", "--speed", "max",
                   "--seed", str(seed), *options]
        for robot in robots:
            command += ["--robot", robot]
        if world:
            command += ["--world", world if world.endswith(".yaml") else "worlds/%s.yaml" % world]
        self._said = tempfile.TemporaryFile("w+")  # no pipe: nobody reads on once it has begun
        self._reader: Optional[threading.Thread] = None
        self._process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=self._said,
                                         text=True)
        self.robots: List[RobotView] = []
        try:
            self._meet(len(robots))
        except BaseException:
            self.close()
            raise

    def _meet(self, count: int) -> None:
        for _ in range(count):
            line = self._process.stdout.readline()
            while line.startswith("       "):
                line = self._process.stdout.readline()
            if not line.startswith("ready: "):
                self._process.wait()
                self._said.seek(0)
                raise RuntimeError("the world did not start: %s" % self._said.read())
            name = line.split()[1]
            self.robots.append(RobotView(self, name, line.partition("://")[2].strip()))
        self._simulator = self.robots[0].simulator
        self.ask(self._simulator, "pause")
        self.stepSize = self._simulator.call("stepSize")  # [s]
        self._reader = threading.Thread(target=self._drain, daemon=True)
        self._reader.start()

    def _drain(self) -> None:
        """What the daemon logs afterwards; unread, it would hold the daemon up one day."""
        for _ in self._process.stdout:
            pass

    @property
    def robot(self) -> RobotView:
        """The first one."""
        return self.robots[0]

    def __enter__(self) -> "World":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def time(self) -> float:
        """Simulated [s]."""
        return self._simulator.call("time")

    def hash(self) -> str:
        """A number of the whole state, equal for equal runs."""
        return self._simulator.call("hash")

    def ask(self, service: Any, method: str, *arguments: Any) -> Any:
        return service.call(method, *arguments)

    def step(self, seconds: float) -> None:
        """Lets so much time pass, and no more."""
        self._simulator.call("step", max(1, round(seconds / self.stepSize)))

    def runUntil(self, condition: Callable[[], Any], within: float,
                 otherwise: str = "it did not come to that") -> Any:
        """Lets time pass until the condition is true, and returns what it was; it is looked at
        every 10 ms. AssertionError after `within` s."""
        for _ in range(max(1, round(within / BEAT))):
            found = condition()
            if found:
                return found
            self.step(BEAT)
        found = condition()
        assert found, "%s within %g s, at %.2f s" % (otherwise, within, self.time())
        return found

    def placeBall(self, x: float, y: float, z: float = 0.0) -> None:
        """Puts the world's first ball down, at rest [m]."""
        self.ask(self._simulator, "placeBall", float(x), float(y), float(z))

    def ball(self) -> List[float]:
        """x, y, z [m] of the world's first ball."""
        return self._simulator.call("ballPose")

    def close(self) -> None:
        """Ends it all."""
        for robot in self.robots:
            robot.close()
        self._process.kill()
        self._process.wait()
        if self._reader:
            self._reader.join()
        self._process.stdout.close()
        self._said.close()
