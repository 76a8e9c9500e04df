"""Boxes at work: signals go along the links, code runs, timelines are played by the robot."""

import inspect
import logging
import os
import threading
import time
import traceback
from typing import Any, Callable, Dict, List, Optional

from usarnaoqi_sdk.al import ALProxy
from usarnaoqi_sdk import Session

from .project import ON_LOAD, ON_START, ON_STOP, OUTSIDE, Box, Diagram
from .script import GeneratedClass, makeClass

_log = logging.getLogger("usarnaoqi_behavior")
_TICK = 0.02  # [s] how often it is looked whether a frame has come


class Behavior:
    """A behavior on the robot at `address` ("host:port"). Every signal runs in a thread of its own,
    as in NaoQi; the behavior has ended when none runs any more."""

    def __init__(self, root: Box, file: str, address: str):
        self.file, self.folder = file, os.path.dirname(os.path.abspath(file))
        self._host, _, port = address.rpartition(":")
        self._port = int(port)
        self._address = address
        self._session: Optional[Session] = None
        self.errors: List[str] = []
        self.motions: set = set()  # ids of ALFrameManager, under way
        self._busy = 0
        self._changed = threading.Condition()
        self.stopping = False
        self._root = Running(root, self, None, None)

    def run(self) -> Any:
        """Starts it and waits for its end."""
        self._root.load()
        for id_, (_, nature) in self._root.box.inputs.items():
            if nature == ON_START:
                self._root.signal(id_, None)
        with self._changed:
            while self._busy > 0 and not self.stopping:
                self._changed.wait(0.1)
        self._root.unload()
        for motion in list(self.motions):
            self.proxy("ALFrameManager").deleteBehavior(motion)

    @property
    def session(self) -> Session:
        with self._changed:
            if self._session is None:
                self._session = Session(self._address)
            return self._session

    def stop(self) -> None:
        with self._changed:
            self.stopping = True
            self._changed.notify_all()

    def proxy(self, name: str, *_: Any) -> ALProxy:
        """Whatever address a box has written down: this robot."""
        return ALProxy(name, self._host, self._port)

    def spawn(self, work: Callable[..., None], *arguments: Any) -> None:
        with self._changed:
            self._busy += 1
        threading.Thread(target=self._do, args=(work, arguments), daemon=True).start()

    def tell(self, box: Box, error: BaseException) -> None:
        """Of an error in a box; the others go on."""
        lines = traceback.format_exception_only(type(error), error)
        self.errors.append("%s: the box \"%s\": %s" % (self.file, box.name, lines[-1].strip()))
        _log.error("%s", self.errors[-1])

    def now(self) -> float:
        """[s] of the robot's time; of the wall's where the robot does not tell."""
        try:
            return float(self.session.service("UsarSim").call("time"))
        except RuntimeError:
            return time.monotonic()

    def _do(self, work: Callable[..., None], arguments: Any) -> None:
        try:
            work(*arguments)
        finally:
            with self._changed:
                self._busy -= 1
                self._changed.notify_all()


class Running:
    """A box of a running behavior, in a diagram of the box `around`; `pass_on` takes what it gives:
    its id, the output's id, a value."""

    def __init__(self, box: Box, behavior: Behavior, around: "Optional[Running]",
                 pass_on: "Optional[Callable[[str, str, Any], None]]"):
        self.box, self.behavior = box, behavior
        self._around, self._pass_on = around, pass_on
        self._script: Optional[GeneratedClass] = None
        self._diagrams: List[_RunningDiagram] = []
        self._run = 0  # counts starts and stops, so that an old timeline knows it is over

    def load(self) -> None:
        self._diagrams = [_RunningDiagram(diagram, self) for diagram in self.box.diagrams]
        if self.box.code.strip():
            try:
                made = makeClass(self.box.code, "the box " + self.box.name, self.box.outputs,
                                 self.behavior.proxy)
                script = made.__new__(made)
                script._box = self
                script.__init__()
                self._script = script
                script.onLoad()
            except Exception as error:  # pylint: disable=broad-except  # somebody's code
                self.behavior.tell(self.box, error)
        for diagram in self._diagrams:
            diagram.load()

    def unload(self) -> None:
        self._run += 1
        for diagram in self._diagrams:
            diagram.unload()
        if self._script:
            self._call(self._script.onUnload)

    def signal(self, input_id: str, value: Any) -> None:
        """Something arrives at an input; does not wait."""
        self.behavior.spawn(self._receive, input_id, value)

    def give(self, output_id: str, value: Any) -> None:
        """Its output fires."""
        if self._pass_on:
            self._pass_on(self.box.id, output_id, value)
        elif self.box.outputs.get(output_id) == "onStopped":
            self.behavior.stop()

    def getParameter(self, name: str) -> Any:
        if name in self.box.inherited and self._around:
            return self._around.getParameter(name)
        return self.box.parameters[name]

    def setParameter(self, name: str, value: Any) -> None:
        self.box.parameters[name] = value

    def _receive(self, input_id: str, value: Any) -> None:
        name, nature = self.box.inputs.get(input_id, ("", ""))
        if nature == ON_STOP:
            self._run += 1
        handler = getattr(self._script, "onInput_" + name, None)
        if handler:
            self._call(handler, value)
        if self.box.moves and nature == ON_START:
            self._play()
        elif not self.box.moves:
            for diagram in self._diagrams[:1]:
                diagram.follow(OUTSIDE, input_id, value)

    def _call(self, handler: Callable[..., Any], *values: Any) -> None:
        try:
            wanted = len(inspect.signature(handler).parameters)
            handler(*values[:wanted], *[None] * (wanted - len(values)))
        except Exception as error:  # pylint: disable=broad-except  # somebody's code
            self.behavior.tell(self.box, error)

    # A timeline: its curves, and its diagrams each from its frame on; then it has stopped.
    def _play(self) -> None:
        self._run += 1
        mine = self._run
        begin = self.behavior.now()
        text = self.box.motion()
        frames = self.behavior.proxy("ALFrameManager") if text else None
        motion = frames.newBehavior(self.box.name, text) if frames else None
        try:
            length = 0.0
            if motion:
                self.behavior.motions.add(motion)
                frames.playBehavior(motion)
                length = frames.getMotionLength(motion)
            length = max([length] + [self._timeOf(d.frame) for d in self.box.diagrams])
            if self.box.lastFrame is not None:
                length = self._timeOf(self.box.lastFrame)
            due = sorted(self._diagrams, key=lambda diagram: diagram.plan.frame)
            while self._run == mine and not self.behavior.stopping:
                passed = self.behavior.now() - begin
                while due and self._timeOf(due[0].plan.frame) <= passed:
                    due.pop(0).start()
                if passed >= length:
                    break
                time.sleep(_TICK)
        except RuntimeError as error:
            self.behavior.tell(self.box, error)
        finally:
            if motion in self.behavior.motions:
                self.behavior.motions.discard(motion)
                frames.deleteBehavior(motion)
        if self._run != mine:
            return
        for id_, name in self.box.outputs.items():
            if name == "onStopped":
                self.give(id_, None)

    def _timeOf(self, frame: float) -> float:
        return max(0.0, (frame - self.box.firstFrame) / self.box.fps)


class _RunningDiagram:
    def __init__(self, plan: Diagram, around: Running):
        self.plan, self._around = plan, around
        self._boxes: Dict[str, Running] = {
            id_: Running(box, around.behavior, around, self.follow)
            for id_, box in plan.boxes.items()}

    def load(self) -> None:
        for box in self._boxes.values():
            box.load()
        for id_, (_, nature) in self._around.box.inputs.items():
            if nature == ON_LOAD and not self._around.box.moves:
                self.follow(OUTSIDE, id_, None)

    def unload(self) -> None:
        for box in self._boxes.values():
            box.unload()

    def start(self) -> None:
        """On a timeline: whatever is linked to a beginning, or everybody where nothing is."""
        inputs = self._around.box.inputs
        for link in self.plan.links:
            if link.source == OUTSIDE and inputs.get(link.output, ("", ""))[1] != ON_STOP:
                self._deliver(link.target, link.input, None)
        if not self.plan.links:
            for box in self._boxes.values():
                for id_, (_, nature) in box.box.inputs.items():
                    if nature == ON_START:
                        box.signal(id_, None)

    def follow(self, source: str, output: str, value: Any) -> None:
        """Takes what a box gives to those that are linked to it."""
        for link in self.plan.links:
            if link.source == source and link.output == output:
                self._deliver(link.target, link.input, value)

    def _deliver(self, target: str, input_id: str, value: Any) -> None:
        if target == OUTSIDE:
            self._around.give(input_id, value)
        elif target in self._boxes:
            self._boxes[target].signal(input_id, value)
