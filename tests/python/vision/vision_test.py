"""OpenCV does on our pictures what it does on real ones: it finds ball, lines and markers where the
camera's lens says they are."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

try:
    import cv2
    import numpy
except ImportError:
    cv2 = None

PROGRAM = os.environ.get("USARNAOQI", "")
ROOT = pathlib.Path(__file__).resolve().parents[3]
VERSIONS = ("nao_h21_v33", "nao_h25_v50", "nao_h25_v60")
EFFECTS = "response,noise,vignetting"

# How this ball has been found on real robots' pictures, in OpenCV's units.
ORANGE = ((7, 193, 171), (21, 255, 255))

FIELD = (ROOT / "worlds" / "field_2011.yaml").read_text()


class View:
    """Where a picture was taken from, and its pinhole."""

    def __init__(self, camera):
        self.place = numpy.array(camera["position"])
        self.turn = numpy.array(camera["rotation"])
        self.matrix = numpy.array([[camera["fx"], 0, camera["cx"]],
                                   [0, camera["fy"], camera["cy"]], [0, 0, 1]])

    def in_camera(self, point):
        """Right, down, ahead."""
        ahead, left, up = self.turn.T @ (numpy.array(point) - self.place)
        return numpy.array([-left, -up, ahead])

    def turn_in_camera(self, axes):
        """The same axes by right, down, ahead."""
        return numpy.array([[0, -1, 0], [0, 0, -1], [1, 0, 0]]) @ self.turn.T @ axes

    def project(self, point):
        u, v, w = self.matrix @ self.in_camera(point)
        return numpy.array([u / w, v / w])

    def ahead(self, distance, right=0.0, down=0.0):
        """The point of the world this far away, in parts of it to the right and down."""
        return self.place + self.turn @ (distance * numpy.array([1, -right, -down]))


@unittest.skipIf(cv2 is None, "no OpenCV for this Python (python3-opencv)")
@unittest.skipUnless(PROGRAM, "USARNAOQI names no program")
class VisionTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def render(self, world, *options):
        """The picture of a world given as YAML, as OpenCV has it, and its view."""
        (self.folder / "world.yaml").write_text(world)
        picture = self.folder / "picture.png"
        told = subprocess.run(
            [PROGRAM, "render", "--world", str(self.folder / "world.yaml"), "--robots-dir",
             str(ROOT / "robots"), "--out", str(picture), "--json", *options],
            check=True, capture_output=True, text=True, timeout=60).stdout
        return cv2.imread(str(picture)), View(json.loads(told)["camera"])

    def look(self, world, robot="nao_h25_v50", effects=EFFECTS, *options):
        return self.render(world, "--robot", robot, "--posture", "StandInit", "--effects", effects,
                           *options)

    def test_hue_finds_the_orange_ball_from_near_and_far(self):
        for robot in VERSIONS:
            _, view = self.look(FIELD, robot)
            for distance in (0.3, 0.5, 1.0, 2.0, 3.0):
                for right in (0.0, 0.15):
                    spot = view.ahead(distance, right, 0.15)
                    spot[2] = max(spot[2], 0.0325)
                    with self.subTest(robot=robot, distance=distance, right=right):
                        self.check_ball(robot, spot)

    def check_ball(self, robot, spot):
        picture, view = self.look(with_ball(spot), robot)
        mask = cv2.inRange(cv2.cvtColor(picture, cv2.COLOR_BGR2HSV), *ORANGE)
        self.assertGreater(cv2.countNonZero(mask), 0)
        contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
        (u, v), radius = cv2.minEnclosingCircle(max(contours, key=cv2.contourArea))
        away = numpy.linalg.norm(numpy.array([u, v]) + 0.5 - outline_middle(view, spot))
        self.assertLess(away, 2)
        depth = view.in_camera(spot)[2]
        self.assertAlmostEqual(radius, view.matrix[0, 0] * 0.0325 / depth, delta=2 + 0.06 * radius)

    def test_hough_finds_the_orange_ball(self):
        for robot in VERSIONS:
            _, view = self.look(FIELD, robot)
            for distance in (0.4, 0.8, 1.5):
                spot = view.ahead(distance, 0.1, 0.1)
                with self.subTest(robot=robot, distance=distance):
                    picture, view = self.look(with_ball(spot), robot)
                    red = cv2.medianBlur(picture[:, :, 2], 5)
                    red[:] = cv2.subtract(red, picture[:, :, 0])
                    circles = cv2.HoughCircles(red, cv2.HOUGH_GRADIENT, 1, 200, param1=100,
                                               param2=15, minRadius=4, maxRadius=120)
                    self.assertIsNotNone(circles)
                    away = numpy.linalg.norm(circles[0, 0, :2] + 0.5 - outline_middle(view, spot))
                    self.assertLess(away, 2)

    def test_hough_finds_the_field_lines(self):
        picture, view = self.look(FIELD, "nao_h25_v50", EFFECTS, "--at", "0.5,0,0")
        value = cv2.cvtColor(picture, cv2.COLOR_BGR2HSV)
        white = cv2.inRange(value, (0, 0, 140), (180, 60, 255))
        white[:int(view.project([50, 0, 0])[1]) + 3] = 0  # above the horizon
        found = cv2.HoughLinesP(white, 1, numpy.pi / 720, 40, minLineLength=60, maxLineGap=10)
        self.assertIsNotNone(found)
        for ends in (([2.4, -1, 0], [2.4, 1, 0]), ([3, -0.6, 0], [3, 0.6, 0])):
            from_, to = view.project(ends[0]), view.project(ends[1])
            across = numpy.array([from_[1] - to[1], to[0] - from_[0]])
            across /= numpy.linalg.norm(across)
            # Half the line's width on the picture, which a segment found on its edge lies aside.
            half = abs(view.project([ends[0][0] - 0.025, 0, 0])[1]
                       - view.project([ends[0][0] + 0.025, 0, 0])[1]) / 2
            away = [max(abs(across @ (segment[:2] + 0.5 - from_)),
                        abs(across @ (segment[2:] + 0.5 - from_))) for segment in found[:, 0]]
            self.assertLess(min(away), 2 + half)

    def test_aruco_marker_is_decoded_at_its_pose(self):
        if not hasattr(cv2, "aruco"):
            self.skipTest("OpenCV without aruco")
        dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
        for robot in VERSIONS:
            for turn in (0.0, 0.5, -0.8):
                with self.subTest(robot=robot, turn=turn):
                    _, view = self.look(FIELD, robot)
                    place = view.ahead(1.0, 0.08, -0.05)
                    picture, view = self.look(with_marker(self.folder, place, turn, dictionary),
                                              robot)
                    corners, ids, _ = cv2.aruco.detectMarkers(
                        cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY), dictionary,
                        parameters=refined())
                    self.assertEqual([7], [int(i) for i in (ids if ids is not None else [])])
                    # Pixel centres are whole numbers for OpenCV, halves for us.
                    turned, at, _ = cv2.aruco.estimatePoseSingleMarkers(
                        [corners[0] + 0.5], 0.15, view.matrix, numpy.zeros(4))
                    front = place - 0.005 * numpy.array([numpy.cos(turn), numpy.sin(turn), 0])
                    away = numpy.linalg.norm(at[0, 0] - view.in_camera(front))
                    self.assertLess(away, 0.01)
                    error = cv2.Rodrigues(turned[0, 0])[0].T @ view.turn_in_camera(facing(turn))
                    angle = numpy.arccos(min(1, (numpy.trace(error) - 1) / 2))
                    self.assertLess(numpy.degrees(angle), MOST_TURNED)

    def test_shipped_markers_are_read_by_a_robot_among_them(self):
        if not hasattr(cv2, "aruco"):
            self.skipTest("OpenCV without aruco")
        dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
        for number, heading in enumerate((0, 1.5708, 3.1416, -1.5708)):
            picture = self.folder / "marker.png"
            subprocess.run([PROGRAM, "render", "--world", str(ROOT / "worlds" / "markers.yaml"),
                            "--robots-dir", str(ROOT / "robots"), "--robot", "nao_h25_v50", "--at",
                            f"0,0,{heading}", "--posture", "StandInit", "--out", str(picture)],
                           check=True, capture_output=True, timeout=60)
            _, ids, _ = cv2.aruco.detectMarkers(cv2.imread(str(picture), 0), dictionary)
            self.assertIn([number], ids.tolist() if ids is not None else [])

    def test_v33_and_v40_give_different_pictures_of_one_scene(self):
        eye = ("--from", "0,0,0.5,0,0.3,0", "--fov", "47.8,36.8")
        ideal, _ = self.render(FIELD, *eye)
        shots = [self.look(FIELD, robot)[0] for robot in ("nao_h21_v33", "nao_h21_v40")]
        self.assertEqual(ideal.shape, shots[0].shape)
        grass = [numpy.median(shot[300:].reshape(-1, 3), axis=0) for shot in shots]
        self.assertGreater(numpy.abs(grass[0] - grass[1]).max(), 12)

    def test_a_picture_has_one_hash_everywhere(self):
        def told(environment):
            run = subprocess.run(
                [PROGRAM, "render", "--world", str(ROOT / "worlds" / "field_2011.yaml"),
                 "--robots-dir", str(ROOT / "robots"), "--from", "-0.5,0.25,0.5,0,0,0", "--robot",
                 "nao_h25_v50", "--at", "1,0,0", "--out", str(self.folder / "p.ppm"), "--json"],
                check=True, capture_output=True, text=True, timeout=60,
                env={**os.environ, **environment})
            return json.loads(run.stdout)["hash"]
        plain = told({})
        masked = told({"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX512F,-AVX2,-AVX,-FMA,-FMA4,"
                                         "-AVX2_Usable,-FMA_Usable,-AVX_Usable"})
        self.assertEqual(plain, masked)


# [deg] between a marker's true pose and the one OpenCV finds. Corners are found to 0.3 px. A marker
# of 15 cm seen from 1 m straight ahead shows its tilt only in how much longer its near side is:
# f * 0.15^2 = 12 to 16 px a radian, so that 0.3 px are 1.4 degrees.
MOST_TURNED = 2.0


def facing(turn):
    """Axes of a marker on a board turned by this, as ArUco has them: right and up on its face, and
    out of it. A board that is not turned looks along -x."""
    c, s = numpy.cos(turn), numpy.sin(turn)
    return numpy.array([[s, 0, -c], [-c, 0, -s], [0, 1, 0]])


def refined():
    parameters = cv2.aruco.DetectorParameters_create()
    parameters.cornerRefinementMethod = cv2.aruco.CORNER_REFINE_SUBPIX
    return parameters


def with_ball(spot):
    """The field of 2011 with its ball here."""
    x, y, z = (float(p) for p in spot)
    moved = FIELD.replace("position: [0, 0, 0.0325]", f"position: [{x:.6f}, {y:.6f}, {z:.6f}]")
    assert moved != FIELD
    return moved


def with_marker(folder, place, turn, dictionary):
    """A field with marker 7, 15 cm wide, on a board whose face looks back at the robot."""
    rows = cv2.aruco.drawMarker(dictionary, 7, 6)
    bits = "\n".join(" ".join(["0"] + ["0" if v else "1" for v in row] + ["0"]) for row in rows)
    rim = " ".join("0" * 8)
    (folder / "marker.pbm").write_text(f"P1\n8 8\n{rim}\n{bits}\n{rim}\n")
    x, y, z = (float(p) for p in place)
    return (f"boxes:\n  - {{name: board, position: [{x:.6f}, {y:.6f}, {z:.6f}], "
            f"rpy: [0, 0, {turn}], size: [0.01, 0.2, 0.2], texture: marker.pbm}}\n")


def outline_middle(view, spot):
    """The middle of a ball's outline: where its nearest and its farthest edge fall, half way. A
    sphere off the axis is seen as an ellipse whose middle lies beyond the sphere's own."""
    centre = view.in_camera(spot)
    far = numpy.linalg.norm(centre)
    half = numpy.arcsin(0.0325 / far)
    off = numpy.arctan2(numpy.hypot(centre[0], centre[1]), centre[2])
    direction = centre[:2] / max(numpy.hypot(centre[0], centre[1]), 1e-12)
    middle = (numpy.tan(off - half) + numpy.tan(off + half)) / 2
    focal = numpy.array([view.matrix[0, 0], view.matrix[1, 1]])
    return view.matrix[:2, 2] + focal * middle * direction


if __name__ == "__main__":
    unittest.main()
