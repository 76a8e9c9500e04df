"""The plug-in for pytest, by tests that use it as anybody's would."""

import pytest


def test_time_stands_until_it_is_told_to_pass(usarnaoqi):
    assert usarnaoqi.time() == 0
    usarnaoqi.step(0.5)
    assert usarnaoqi.time() == pytest.approx(0.5)
    assert usarnaoqi.time() == pytest.approx(0.5)


@pytest.mark.usarnaoqi(robots=["a=nao_h21_v33", "b=nao_h25_v50"])
def test_a_world_has_the_robots_asked_for(usarnaoqi):
    assert [robot.name for robot in usarnaoqi.robots] == ["a", "b"]
    assert len(usarnaoqi.robots[1].service("ALMotion").call("getBodyNames", "Body")) == 26


def test_blocking_calls_end_while_time_passes(usarnaoqi):
    robot = usarnaoqi.robot
    robot.do("ALMotion", "wakeUp")
    assert robot.do("ALRobotPosture", "goToPosture", "StandInit", 0.8)
    robot.assertUpright()
    robot.assertAt(0, 0, within=0.1)


def test_a_push_lets_it_fall_and_the_assertion_says_so(usarnaoqi):
    robot = usarnaoqi.robot
    robot.do("ALMotion", "wakeUp")
    robot.push([0, 120, 0], 0.4)
    usarnaoqi.runUntil(lambda: robot.tilt() > 1.2, within=5)
    with pytest.raises(AssertionError, match="nao_h21_v33 has fallen at"):
        robot.assertUpright()


def test_what_does_not_come_is_told_with_its_time(usarnaoqi):
    with pytest.raises(AssertionError, match="it did not come to that within 0.1 s, at 0.10 s"):
        usarnaoqi.runUntil(lambda: False, within=0.1)


def test_a_press_is_felt_by_memory(usarnaoqi):
    robot = usarnaoqi.robot
    usarnaoqi.step(0.1)
    robot.press("Head/Touch/Front", 0.1)
    usarnaoqi.step(0.05)
    assert robot.memory("Device/SubDeviceList/Head/Touch/Front/Sensor/Value") == 1
    usarnaoqi.step(0.1)
    assert robot.memory("Device/SubDeviceList/Head/Touch/Front/Sensor/Value") == 0


@pytest.mark.usarnaoqi(world="red_ball")
def test_a_ball_is_where_it_is_put(usarnaoqi):
    usarnaoqi.placeBall(0.5, 0.2)
    usarnaoqi.step(0.5)
    assert usarnaoqi.ball()[:2] == pytest.approx([0.5, 0.2], abs=1e-3)


@pytest.mark.usarnaoqi(seed=4)
def test_a_world_is_the_same_every_time(usarnaoqi):
    from usarnaoqi_sdk.world import World
    usarnaoqi.step(1)
    with World(seed=4) as other:
        other.step(1)
        assert other.hash() == usarnaoqi.hash()
    with World(seed=5) as other:
        other.step(1)
        assert other.hash() != usarnaoqi.hash()


def test_a_world_that_can_not_be_is_refused_with_the_reason():
    from usarnaoqi_sdk.world import World
    with pytest.raises(RuntimeError, match="the world did not start: .*hal"):
        World(robots=["hal"])


def test_time_is_in_seconds_whatever_the_physics_step():
    from usarnaoqi_sdk.world import World
    with World(options=["--step", "0.001"]) as world:
        world.step(0.25)
        assert world.time() == pytest.approx(0.25)


def test_a_world_that_logs_much_goes_on(usarnaoqi):
    logger = usarnaoqi.robot.service("ALLogger")
    for _ in range(100):  # 64 kB fill a pipe
        logger.call("error", "test", "x" * 1000)
    assert usarnaoqi.time() == pytest.approx(0)
