"""pytest's side: a world of its own for every test that asks for one.

    @pytest.mark.usarnaoqi(robots=["nao_h25_v50"], world="red_ball", seed=3)
    def test_walks(usarnaoqi):
        usarnaoqi.robot.do("ALMotion", "wakeUp")
        usarnaoqi.robot.do("ALMotion", "moveTo", 0.3, 0.0, 0.0)
        usarnaoqi.robot.assertAt(0.3, 0, within=0.1)

Loaded by pytest itself where the package is installed; else by `-p usarnaoqi_sdk.pytest_plugin`."""

import pytest

from .world import World


def pytest_configure(config):
    config.addinivalue_line("markers", "usarnaoqi(robots, world, seed, options): what the world of "
                                       "the fixture `usarnaoqi` is made from")


@pytest.fixture
def usarnaoqi(request):
    """A world whose time stands until the test lets it pass. Gone after the test."""
    marker = request.node.get_closest_marker("usarnaoqi")
    with World(**(marker.kwargs if marker else {})) as world:
        yield world
