"""What a behavior.xar says: boxes, their code, timelines and the links between them. Versions 1
(child elements) and 3 (attributes) are read alike."""

import xml.etree.ElementTree as ElementTree
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

ON_LOAD, ON_EVENT, ON_START, ON_STOP = "0", "1", "2", "3"  # `nature` of an input
OUTSIDE = "0"  # id of the box around a diagram, in its links


class ProjectError(Exception):
    """A file that is no behavior; the sentence names file and line."""


class Link(NamedTuple):
    source: str  # box
    output: str
    target: str  # box
    input: str


class Diagram(NamedTuple):
    frame: float  # at which it starts
    boxes: "Dict[str, Box]"
    links: List[Link]


class Box:
    """One box; ids are texts, as the file has them."""

    def __init__(self, element):
        self.name = _text(element, "name")
        self.id = _text(element, "id")
        self.inputs = {_text(i, "id"): (_text(i, "name"), _text(i, "nature"))
                       for i in _all(element, "Input")}
        self.outputs = {_text(o, "id"): _text(o, "name") for o in _all(element, "Output")}
        self.parameters: Dict[str, Any] = {}
        self.inherited = set()  # names of parameters that are those of the box around
        for parameter in _all(element, "Parameter"):
            name = _text(parameter, "name")
            self.parameters[name] = _value(parameter)
            if _text(parameter, "inherits_from_parent") == "1":
                self.inherited.add(name)
        script = _first(element, "script")
        self.code = "" if script is None else _text(script, "content").strip("\r\n")
        self.timeline = _first(element, "Timeline")
        self.diagrams = [] if self.timeline is None else _diagrams(self.timeline)

    @property
    def moves(self) -> bool:
        """Whether it has a timeline of its own that runs when it starts."""
        return self.timeline is not None and _text(self.timeline, "enable") in ("1", "true")

    @property
    def fps(self) -> float:
        return float(_text(self.timeline, "fps") or 25)

    @property
    def firstFrame(self) -> float:
        return float(_text(self.timeline, "start_frame") or 0)

    @property
    def lastFrame(self) -> Optional[float]:
        end = float(_text(self.timeline, "end_frame") or -1)
        return end if end >= 0 else None

    def motion(self) -> Optional[str]:
        """Its own curves as a behavior without code and boxes; None if it has none."""
        lists = _all(self.timeline, "ActuatorList")
        if not any(_all(each, "ActuatorCurve") for each in lists):
            return None
        timeline = _plain(self.timeline)
        for layer in _all(timeline, "BehaviorLayer"):
            timeline.remove(layer)
        root = ElementTree.Element("ChoregrapheProject", {"xar_version": "3"})
        box = ElementTree.SubElement(root, "Box", {"name": self.name, "id": "-1"})
        box.append(timeline)
        return ElementTree.tostring(root, encoding="unicode")


def loadProject(file: str) -> Box:
    """The root box of a behavior. Raises ProjectError, or OSError if it can not be read."""
    try:
        root = ElementTree.parse(file).getroot()
    except ElementTree.ParseError as error:
        raise ProjectError("%s:%d: no well-formed XML" % (file, error.position[0])) from None
    box = _first(root, "Box")
    if _tag(root) != "ChoregrapheProject" or box is None:
        raise ProjectError("%s:1: expected a <Box> in a <ChoregrapheProject>" % file)
    return Box(box)


def _diagrams(timeline) -> List[Diagram]:
    found = []
    for layer in _all(timeline, "BehaviorLayer"):
        if _text(layer, "mute") in ("1", "true"):
            continue
        for keyframe in _all(layer, "BehaviorKeyframe"):
            diagram = _first(keyframe, "Diagram")
            if diagram is not None:
                boxes = [Box(element) for element in _all(diagram, "Box")]
                found.append(Diagram(float(_text(keyframe, "index") or 0),
                                     {box.id: box for box in boxes},
                                     [_link(element) for element in _all(diagram, "Link")]))
    return found


def _link(element) -> Link:
    return Link(_text(element, "outputowner"), _text(element, "indexofoutput"),
                _text(element, "inputowner"), _text(element, "indexofinput"))


def _value(parameter) -> Any:
    kind, text = _text(parameter, "content_type"), _text(parameter, "value")
    try:
        return {"0": lambda: bool(int(text)), "1": lambda: int(text),
                "2": lambda: float(text)}.get(kind, lambda: text)()
    except ValueError:
        return text


def _plain(element):
    """A copy without name spaces."""
    copy = ElementTree.Element(_tag(element), element.attrib)
    copy.text = element.text
    copy.extend([_plain(child) for child in element])
    return copy


def _tag(element) -> str:
    return element.tag.split("}")[-1]


def _all(element, tag: str) -> list:
    return [child for child in element if _tag(child) == tag]


def _first(element, tag: str):
    return next(iter(_all(element, tag)), None)


def _text(element, name: str) -> str:
    if name in element.attrib:
        return element.attrib[name]
    child = _first(element, name)
    return "" if child is None else child.text or ""
