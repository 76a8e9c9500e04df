"""Turns Google Benchmark's results into the project's figures: medians, and ratios of medians."""
import json
import pathlib
import sys


def medians(folder):
    """Counter values of every benchmark's median, by benchmark and counter."""
    found = {}
    for file in sorted(pathlib.Path(folder).glob("*.json")):
        for run in json.loads(file.read_text())["benchmarks"]:
            if run.get("error_occurred"):
                sys.exit(f"bench: {run['name']}: {run['error_message']}")
            if run.get("aggregate_name") == "median":
                found[run["run_name"]] = run
    return found


def figures(runs):
    """The names of these figures are fixed; all times are processor time."""
    step = runs["standing"]["step_us"]
    mujoco = runs["mujocoStanding"]["step_us"]
    return {
        "step_cpu_us": step,
        "step_walking_cpu_us": runs["walking"]["step_us"],
        "realtime_factor": runs["standing"]["realtime_factor"],
        "realtime_factor_walking": runs["walking"]["realtime_factor"],
        "mujoco_step_cpu_us": mujoco,
        "ratio_to_mujoco": mujoco / step,
        **render_figures(runs),
    }


def render_figures(runs):
    """Pictures per second of processor time: a field with goals and a ball, and with six robots."""
    found = {}
    for width, height in ((640, 480), (320, 240)):
        for robots, suffix in ((0, ""), (6, "_6_robots")):
            run = runs[f"renderYuv422/width:{width}/robots:{robots}"]
            found[f"render_{width}x{height}{suffix}_fps"] = run["fps"]
    return found


def main():
    found = {name: round(value, 3) for name, value in figures(medians(sys.argv[1])).items()}
    if "--json" in sys.argv[2:]:
        print(json.dumps({"command": "bench", "robot": "nao_h21_v33", "step_s": 0.002,
                          "figures": found}))
        return
    for name, value in found.items():
        print(f"{name:28} {value:12.3f}")


if __name__ == "__main__":
    main()
