"""Python 2's operators: `a / b` of whole numbers, and `a < b` of what Python 3 does not compare,
become calls that do as it did."""

from typing import Any

DIVIDE = "py2_divide"
COMPARE = {"<": "py2_less", ">": "py2_greater", "<=": "py2_less_equal", ">=": "py2_greater_equal"}


def translated(tree: Any, text: str) -> str:
    """The text of a tree of lib2to3's, its operators replaced."""
    _visit(tree, "import division" not in text)
    return str(tree)


def _visit(node: Any, divides: bool) -> None:
    for child in list(node.children):
        _visit(child, divides)
    if len(node.children) < 3:
        return
    operators = [str(child).strip() for child in node.children[1::2]]
    if len(node.children) == 3 and operators[0] in COMPARE:
        _replaceComparison(node, COMPARE[operators[0]])
    elif divides and "/" in operators and _isTerm(node):
        _replace(node)
    elif divides and len(node.children) == 3 and operators[0] == "/=":
        _replaceAugmented(node)


def _replaceComparison(node: Any, name: str) -> None:
    """Of two; a chain of more stays as it is."""
    first, _, second = node.children
    prefix = first.prefix
    _become(node, prefix, "%s(%s,%s)" % (name, str(first)[len(prefix):], second))


def _isTerm(node: Any) -> bool:
    """A chain of factors, not a parameter list with a lone slash."""
    operators = {str(child).strip() for child in node.children[1::2]}
    return operators <= {"*", "/", "%", "//", "@"} and len(node.children) % 2 == 1


def _replace(node: Any) -> None:
    """From the left: what stands before a slash is its first argument."""
    first = node.children[0]
    prefix = first.prefix
    text = str(first)[len(prefix):]
    for operator, operand in zip(node.children[1::2], node.children[2::2]):
        if str(operator).strip() == "/":
            text = "%s(%s,%s)" % (DIVIDE, text, operand)
        else:
            text += str(operator) + str(operand)
    _become(node, prefix, text)


def _replaceAugmented(node: Any) -> None:
    target, _, value = node.children
    text = "%s = %s(%s,%s)" % (str(target).strip(), DIVIDE, str(target).strip(), value)
    _become(node, target.prefix, text)


def _become(node: Any, prefix: str, text: str) -> None:
    leaf_type = next(leaf for leaf in node.leaves())
    leaf = type(leaf_type)(1, text)  # 1: a name, as far as the printing of the tree goes
    leaf.prefix = prefix
    node.replace(leaf)
