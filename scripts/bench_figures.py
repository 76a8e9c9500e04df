"""Turns Google Benchmark's results into the project's figures: medians, and ratios of medians."""
import json
import math
import pathlib
import sys

ROBOTS = (1, 2, 4, 8, 22)


def medians(folder):
    """Counter values of every benchmark's median, by benchmark and counter."""
    found = {}
    for file in sorted(pathlib.Path(folder).glob("*.json")):
        for run in json.loads(file.read_text())["benchmarks"]:
            if run.get("error_occurred"):
                sys.exit(f"bench: {run['name']}: {run['error_message']}")
            if run.get("aggregate_name") == "median":
                found[run["run_name"].split("/min_time:")[0]] = run
    return found


def figures(folder):
    """The names of these figures are fixed; all times are processor time."""
    runs = medians(folder)
    return {**step_figures(runs), **robot_figures(runs), **snapshot_figures(runs),
            **record_figures(runs),
            **memory_figures(pathlib.Path(folder) / "robots.txt"), **render_figures(runs),
            **walk_figures(runs), **wire_figures(pathlib.Path(folder) / "wire.txt"),
            **lola_figures(pathlib.Path(folder) / "lola.txt")}


def step_figures(runs):
    """One Nao with sensors, self-collision and documented effects, beside MuJoCo and its ideal."""
    step = {name: runs[name]["step_us"]
            for name in ("standing/effects", "standing/ideal", "mujocoStanding",
                         "walking/effects", "walking/ideal", "mujocoWalking")}
    standing = step["mujocoStanding"] / step["standing/effects"]
    walking = step["mujocoWalking"] / step["walking/effects"]
    costs = [step[f"{motion}/effects"] / step[f"{motion}/ideal"]
             for motion in ("standing", "walking")]
    return {
        "step_cpu_us": step["standing/effects"],
        "step_walking_cpu_us": step["walking/effects"],
        "step_with_motion_cpu_us": runs["walkingWithMotion/robots:1"]["step_us"],
        "realtime_factor": runs["standing/effects"]["realtime_factor"],
        "realtime_factor_walking": runs["walking/effects"]["realtime_factor"],
        "mujoco_step_cpu_us": step["mujocoStanding"],
        "mujoco_step_walking_cpu_us": step["mujocoWalking"],
        "ratio_to_mujoco_standing": standing,
        "ratio_to_mujoco_walking": walking,
        "ratio_to_mujoco": math.sqrt(standing * walking),
        "walk_distance_m": runs["walking/effects"]["distance_m"],
        "mujoco_walk_distance_m": runs["mujocoWalking"]["distance_m"],
        "effects_cost_percent": 100 * (math.sqrt(costs[0] * costs[1]) - 1),
    }


def robot_figures(runs):
    """Many Naos on one core: replaying a recorded walk, and walking with motion engines."""
    found = {}
    for robots in ROBOTS:
        run = runs[f"walkingRobots/robots:{robots}"]
        found[f"step_us_per_robot_of_{robots}"] = run["step_us"]
    found["realtime_factor_22_robots"] = run["realtime_factor"]
    with_motion = runs["walkingWithMotion/robots:22"]
    found["realtime_factor_22_robots_with_motion"] = with_motion["realtime_factor"]
    return found


def walk_figures(runs):
    """The quadratic programs of a walk, thread time, best of three each; and a tick of 20 ms."""
    return {"qp_solve_mean_us": runs["solving"]["mean_us"],
            "qp_solve_max_us": runs["solving"]["max_us"],
            "motion_tick_mean_us": runs["motionTick"]["cpu_time"] * 1e-3}


def memory_figures(experiment):
    """From `usarnaoqi experiment robots`: a fresh process, or freed memory hides what robots take."""
    rows = json.loads(experiment.read_text())["figures"]["rows"]
    return {"memory_mb_per_robot": max(row["memory_mb"] for row in rows)}


def wire_figures(bench):
    """Calls and events of the qi wire, with the echo beside them: as bench/wire_bench prints them."""
    return json.loads(bench.read_text())


def lola_figures(bench):
    """How late LoLA's frames are sent at 1x, and a bare sleep in turn: as bench/lola_bench prints."""
    return json.loads(bench.read_text().splitlines()[-1])  # after what was logged


def snapshot_figures(runs):
    """To take a snapshot of a walking Nao, to go back to one, and what 100,000 ways back leave."""
    restore = runs["restore/iterations:100000"]
    return {"snapshot_cpu_us": runs["takeSnapshot"]["snapshot_cpu_us"],
            "restore_cpu_us": restore["restore_cpu_us"],
            "restore_growth_kb": restore["restore_growth_kb"]}


def record_figures(runs):
    """What recording adds to a run's processor time, and the file's growth: a walk with fading
    eyes; a body commanded by LoLA."""
    walk, driven = (runs[f"{name}/iterations:1"] for name in ("recordWalk", "recordDriven"))
    return {"recording_cost_percent": walk["cost_percent"],
            "recording_mb_per_minute": walk["mb_per_minute"],
            "recording_lola_cost_percent": driven["cost_percent"],
            "recording_lola_mb_per_minute": driven["mb_per_minute"]}


def render_figures(runs):
    """Pictures per second of processor time: a field with goals and a ball, and with six robots;
    the same as a camera gives it; and what physics and two cameras of 640x480 take of a core."""
    found = {}
    for width, height in ((640, 480), (320, 240)):
        for robots, suffix in ((0, ""), (6, "_6_robots")):
            run = runs[f"renderYuv422/width:{width}/robots:{robots}"]
            found[f"render_{width}x{height}{suffix}_fps"] = run["fps"]
        found[f"camera_{width}x{height}_6_robots_fps"] = runs[f"cameraYuv422/width:{width}"]["fps"]
    for robots in (1, 7):
        run = runs[f"twoCamerasAndPhysics/robots:{robots}"]
        found[f"two_cameras_30hz_{robots}_robots_core_percent"] = run["cpu_time"] / 10
    return found


def main():
    found = {name: round(value, 3) for name, value in figures(sys.argv[1]).items()}
    if "--json" in sys.argv[2:]:
        print(json.dumps({"command": "bench", "robot": "nao_h21_v33", "step_s": 0.002,
                          "figures": found}))
        return
    for name, value in found.items():
        print(f"{name:38} {value:12.3f}")


if __name__ == "__main__":
    main()
