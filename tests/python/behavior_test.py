"""Behaviors with code in their boxes, on a robot that only takes notes."""

import os
import tempfile
import time
import unittest

import support  # noqa: F401  # finds the package

from usarnaoqi_behavior import Behavior, ProjectError, loadProject

PORTS = """<Input name="onLoad" nature="0" id="1"/><Input name="onStart" nature="2" id="2"/>
<Input name="onStop" nature="3" id="3"/><Output name="onStopped" nature="1" id="4"/>"""


def box(id_, code="", more=""):
    script = "<script language='4'><content><![CDATA[%s]]></content></script>" % code
    return "<Box name='box%s' id='%s'>%s%s%s</Box>" % (id_, id_, script, PORTS, more)


def link(source, output, target, input_):
    return ("<Link inputowner='%s' indexofinput='%s' outputowner='%s' indexofoutput='%s'/>"
            % (target, input_, source, output))


def project(inside):
    return ("<ChoregrapheProject xmlns='http://www.aldebaran-robotics.com/schema/choregraphe/"
            "project.xsd' xar_version='3'><Box name='root' id='-1'>%s<Timeline enable='0'>"
            "<BehaviorLayer><BehaviorKeyframe index='1'><Diagram>%s</Diagram></BehaviorKeyframe>"
            "</BehaviorLayer></Timeline></Box></ChoregrapheProject>" % (PORTS, inside))


class Notes:
    """A robot: every call of any service is a line."""

    def __init__(self, name, lines):
        self._name, self._lines = name, lines

    def __getattr__(self, method):
        def call(*arguments):
            self._lines.append((method,) + arguments)
            return {"newBehavior": "7", "getMotionLength": 0.05}.get(method)
        return call


class OnPaper(Behavior):
    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.lines = []

    def proxy(self, name, *_):
        return Notes(name, self.lines)


def run(text):
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "behavior.xar")
        with open(file, "w", encoding="utf-8") as out:
            out.write(text)
        behavior = OnPaper(loadProject(file), file, "127.0.0.1:1")
        behavior.now = time.monotonic
        behavior.run()
    return behavior


SAY = """class MyClass(GeneratedClass):
    def __init__(self):
        GeneratedClass.__init__(self)
    def onInput_onStart(self, p):
        ALProxy("ALTextToSpeech", "nao.local", 9559).say(%s)
        self.onStopped(%s)
"""


class BehaviorTest(unittest.TestCase):
    def test_a_box_starts_when_the_one_before_it_has_stopped_and_hears_its_value(self):
        behavior = run(project(box("1", SAY % ("'one'", "'two'")) + box("2", SAY % ("p", "None")) +
                               link("0", "2", "1", "2") + link("1", "4", "2", "2") +
                               link("2", "4", "0", "4")))
        self.assertEqual(behavior.lines, [("say", "one"), ("say", "two")])
        self.assertEqual(behavior.errors, [])

    def test_code_of_python_2_runs_where_python_can_translate_it(self):
        try:
            import lib2to3  # noqa: F401
        except ImportError:
            self.skipTest("this Python has no lib2to3")
        behavior = run(project(box("1", "class MyClass(GeneratedClass):\n"
                                        "  def onInput_onStart(self):\n"
                                        "    print 'hello',\n"
                                        "    ALMotion.wakeUp()\n") + link("0", "2", "1", "2")))
        self.assertEqual(behavior.lines, [("wakeUp",)])

    def test_translated_words_mean_what_they_did(self):
        try:
            import lib2to3  # noqa: F401
        except ImportError:
            self.skipTest("this Python has no lib2to3")
        behavior = run(project(box("1", "class MyClass(GeneratedClass):\n"
                                        "  def onInput_onStart(self):\n"
                                        "    print 'hello',\n"
                                        "    exec 'half = 7 / 2'\n"
                                        "    l = map(abs, [1, -2])\n"
                                        "    l.sort(lambda a, b: b - a)\n"
                                        "    ALMotion.told(7 / 2, l, 0 <= None)\n") +
                               link("0", "2", "1", "2")))
        self.assertEqual(behavior.errors, [])
        self.assertEqual(behavior.lines, [("told", 3, [2, 1], False)])

    def test_parameters_have_their_types_and_may_be_those_of_the_box_around(self):
        own = "<Parameter name='n' content_type='1' value='3' inherits_from_parent='0' id='9'/>"
        code = SAY % ("self.getParameter('n') + 1", "None")
        self.assertEqual(run(project(box("1", code, own) + link("0", "2", "1", "2"))).lines,
                         [("say", 4)])

    def test_a_timeline_is_played_by_the_robot_and_then_the_box_has_stopped(self):
        curve = ("<Timeline enable='1' fps='10'><ActuatorList><ActuatorCurve actuator='HeadYaw'>"
                 "<Key frame='1' value='3'/></ActuatorCurve></ActuatorList></Timeline>")
        behavior = run(project(box("1", "", curve) + box("2", SAY % ("'done'", "None")) +
                               link("0", "2", "1", "2") + link("1", "4", "2", "2")))
        calls = [line[0] for line in behavior.lines]
        self.assertEqual(calls[:3], ["newBehavior", "playBehavior", "getMotionLength"])
        self.assertIn(("deleteBehavior", "7"), behavior.lines)
        self.assertIn(("say", "done"), behavior.lines)
        sent = behavior.lines[0][2]
        self.assertIn('<Key frame="1" value="3"', sent)
        self.assertNotIn("ns0", sent)

    def test_an_error_in_a_box_is_told_with_its_box_and_the_others_go_on(self):
        behavior = run(project(box("1", SAY % ("1 / 0", "None")) + box("2", SAY % ("2", "None")) +
                               box("3", "def broken(") + link("0", "2", "1", "2") +
                               link("0", "2", "2", "2")))
        self.assertEqual(behavior.lines, [("say", 2)])
        self.assertEqual(len(behavior.errors), 2)
        self.assertIn('the box "box3": SyntaxError', behavior.errors[0])
        self.assertIn('the box "box1": ZeroDivisionError: division by zero', behavior.errors[1])

    def test_what_is_no_behavior_is_refused_with_its_line(self):
        for text, sentence in (("<a>\n<b></a>", ":2: no well-formed XML"),
                               ("<Other/>", ":1: expected a <Box> in a <ChoregrapheProject>")):
            with self.assertRaises(ProjectError) as caught:
                run(text)
            self.assertTrue(str(caught.exception).endswith(sentence), caught.exception)


if __name__ == "__main__":
    unittest.main()
