"""The names that end with InPlace: what the function without it returns becomes the last
argument."""

from typing import Any, Callable, Dict

from . import tools, transforms

_FUNCTIONS = (
    tools.pose2DFromPosition2D, tools.pose2DFromPosition6D, tools.position2DFromPose2D,
    tools.position6DFromPose2D, tools.position6DFromPosition3D, tools.changeReferencePose2D,
    transforms.pose2DFromTransform, transforms.position2DFromTransform,
    transforms.position3DFromTransform, transforms.position6DFromTransform,
    transforms.position6DFromTransformDiff, transforms.rotationFromTransform,
    transforms.transformFromPose2D, transforms.transformFromPosition3D,
    transforms.transformFromRotVec, transforms.transformFromRotation,
    transforms.transformLogarithm, transforms.transformMean)


def _inPlace(function: Callable[..., Any]) -> Callable[..., None]:
    def become(*arguments: Any) -> None:
        arguments[-1]._become(function(*arguments[:-1]))

    become.__name__ = become.__qualname__ = function.__name__ + "InPlace"
    become.__doc__ = "%s(), into the last argument." % function.__name__
    return become


def transformInvertInPlace(transform: transforms.Transform) -> None:
    """It becomes its inverse."""
    transform._become(transform.inverse())


ALL: Dict[str, Callable[..., Any]] = {function.__name__ + "InPlace": _inPlace(function)
                                      for function in _FUNCTIONS}
ALL["transformInvertInPlace"] = transformInvertInPlace
