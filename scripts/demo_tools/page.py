"""The demo's results as one page that needs nothing from elsewhere."""

import base64
import math
from html import escape
from typing import List, Sequence

from plot import Plot
from recorder import Sample, inWorld

SHOWN_JOINTS = ["HeadPitch", "RShoulderPitch", "RElbowRoll", "LHipPitch", "LKneePitch",
                "LAnklePitch", "LHipRoll", "RHipRoll"]

STYLE = """
:root { color-scheme: light; --true: #0072b2; --odometry: #d55e00; --ink: #1c2430; --soft: #5d6b7c; }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1180px; padding: 28px 24px 60px; color: var(--ink);
       background: #fff; font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; }
h1 { font-size: 26px; margin: 0 0 4px; } h2 { font-size: 18px; margin: 34px 0 8px; }
p { margin: 0 0 10px; max-width: 75ch; color: var(--soft); }
.two { display: grid; grid-template-columns: repeat(auto-fit, minmax(420px, 1fr)); gap: 18px; }
table { border-collapse: collapse; width: 100%; font-size: 14px; }
th, td { text-align: left; padding: 5px 10px 5px 0; border-bottom: 1px solid #e3e8ee;
         vertical-align: top; }
th { color: var(--soft); font-weight: 600; } td.number { text-align: right; white-space: nowrap; }
svg { width: 100%; height: auto; display: block; } img { width: 100%; display: block;
      border: 1px solid #d5dce4; }
figure { margin: 0; } figcaption { color: var(--soft); font-size: 13px; padding-top: 4px; }
.legend { display: flex; gap: 22px; font-size: 14px; margin: 0 0 6px; }
.legend svg { width: 34px; height: 12px; display: inline-block; margin-right: 7px; }
svg text { font: 12px system-ui, "DejaVu Sans", sans-serif; fill: var(--soft); }
svg .title { font-size: 14px; font-weight: 600; fill: var(--ink); }
svg .xtick, svg .label, svg .bandname { text-anchor: middle; } svg .ytick { text-anchor: end; }
svg .bandname { font-size: 10px; fill: #8b97a5; } svg .markname { fill: var(--ink); }
.grid { stroke: #dfe5ec; stroke-width: 1; } .band0 { fill: #f3f6f9; } .band1 { fill: #fff; }
.curve { fill: none; stroke-linejoin: round; }
.commanded { stroke: var(--odometry); stroke-width: 3.6; opacity: 0.5; }
.measured { stroke: var(--true); stroke-width: 1.5; }
.true { stroke: var(--true); stroke-width: 2.2; }
.odometry { stroke: var(--odometry); stroke-width: 2.2; stroke-dasharray: 6 4; }
.marker { stroke: #fff; stroke-width: 1.5; } .marker.true { fill: var(--true); }
.marker.odometry { fill: var(--odometry); } .marker.start { fill: var(--ink); }
"""


def toHtml(joints: Sequence[str], samples: Sequence[Sample], steps: Sequence, figures: Sequence,
           pictures: Sequence) -> str:
    """`steps` have name, start and end [s]; figures are (name, value); pictures (name, PNG)."""
    return "\n".join([
        '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8">'
        "<title>UsarNaoQi demo</title><style>%s</style></head><body>" % STYLE,
        "<h1>UsarNaoQi demo</h1><p>A simulated Nao, driven over its own wire by an ordinary "
        "client; a second connection took %d samples meanwhile.</p>" % len(samples),
        '<div class="two"><section><h2>What it did</h2>%s</section>'
        "<section><h2>Figures</h2>%s</section></div>" % (_stepTable(steps), _table(figures)),
        "<h2>Ground track</h2><p>Where the robot really went, and where its odometry thinks it "
        "went, laid over each other at the start.</p>", _trackLegend(), _track(samples),
        "<h2>Joints</h2><p>Commands and encoder readings, the latter on top. The numbers along "
        "the top edge are the steps of the table above.</p>", _jointLegend(),
        '<div class="two">%s</div>' % _jointPlots(joints, samples, steps),
        "<h2>Torso tilt</h2><p>What the inertial sensor makes of it, and how it really is.</p>",
        _legend(("commanded", "true"), ("measured", "inertial sensor")),
        '<div class="two">%s</div>' % _tiltPlots(samples, steps),
        "<h2>What it saw</h2>", '<div class="two">%s</div>' % _pictures(pictures),
        "</body></html>\n"])


def _stepTable(steps) -> str:
    rows = "".join('<tr><td>%d</td><td>%s</td><td class="number">%.1f s</td></tr>' % (
        i, escape(step.name), step.end - step.start) for i, step in enumerate(steps, 1))
    return "<table><tr><th>#</th><th>step</th><th>took</th></tr>%s</table>" % rows


def _table(figures) -> str:
    rows = "".join("<tr><td>%s</td><td>%s</td></tr>" % (escape(name), escape(value))
                   for name, value in figures)
    return "<table><tr><th>figure</th><th>value</th></tr>%s</table>" % rows


def _legend(*entries) -> str:
    return '<div class="legend">%s</div>' % "".join(
        '<span><svg viewBox="0 0 34 12"><line class="curve %s" x1="1" x2="33" y1="6" y2="6"/></svg>'
        "%s</span>" % (style, escape(text)) for style, text in entries)


def _trackLegend() -> str:
    return _legend(("true", "true position"), ("odometry", "odometry"))


def _jointLegend() -> str:
    return _legend(("commanded", "commanded"), ("measured", "measured"))


def _track(samples) -> str:
    first = samples[0]
    odometry = [inWorld(sample.odometry, first.odometry, first.true) for sample in samples]
    plot = Plot("Frame R (between the feet) in the world", "x [m]", "y [m]", 1100, 330, equal=True)
    for poses, style in (([sample.true for sample in samples], "true"), (odometry, "odometry")):
        plot.curve([pose.x for pose in poses], [pose.y for pose in poses], style)
        plot.marker(poses[-1].x, poses[-1].y, style)
    plot.marker(first.true.x, first.true.y, "start", "start")
    return plot.svg()


def _jointPlots(joints, samples, steps) -> str:
    plots: List[str] = []
    for name in SHOWN_JOINTS:
        if name in joints:
            joint = joints.index(name)
            plots.append(_pair(name, samples, steps, [s.commanded[joint] for s in samples],
                               [s.measured[joint] for s in samples]))
    return "".join(plots)


def _tiltPlots(samples, steps) -> str:
    return "".join(_pair(name, samples, steps, [s.true_tilt[axis] for s in samples],
                         [s.tilt[axis] for s in samples])
                   for axis, name in enumerate(("Torso roll", "Torso pitch")))


def _pair(title, samples, steps, wide, thin) -> str:
    """Two curves of angles over time, the thin one on top, with the steps behind."""
    times = [sample.time for sample in samples]
    plot = Plot(title, "simulated time [s]", "angle [deg]")
    plot.bands([(max(step.start, times[0]), min(step.end, times[-1]), str(i))
                for i, step in enumerate(steps, 1) if step.end - step.start > 0.3])
    plot.curve(times, [math.degrees(angle) for angle in wide], "commanded")
    plot.curve(times, [math.degrees(angle) for angle in thin], "measured")
    return plot.svg()


def _pictures(pictures) -> str:
    return "".join('<figure><img alt="%s" src="data:image/png;base64,%s"/><figcaption>%s'
                   "</figcaption></figure>" % (
                       escape(name), base64.b64encode(data).decode("ascii"), escape(name))
                   for name, data in pictures)
