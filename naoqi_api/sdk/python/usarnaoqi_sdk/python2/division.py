"""Python 2's `/` of whole numbers: `a / b` becomes a call that divides as it did."""

from typing import Any

CALL = "py2_divide"


def translated(tree: Any, text: str) -> str:
    """The text of a tree of lib2to3's, its divisions replaced."""
    if "import division" not in text:
        _visit(tree)
    return str(tree)


def _visit(node: Any) -> None:
    for child in list(node.children):
        _visit(child)
    if len(node.children) < 3:
        return
    slashes = [child for child in node.children if str(child).strip() == "/" and not child.children]
    if slashes and node.children.index(slashes[0]) % 2 == 1 and _isTerm(node):
        _replace(node)
    elif len(node.children) == 3 and str(node.children[1]).strip() == "/=":
        _replaceAugmented(node)


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
            text = "%s(%s,%s)" % (CALL, text, operand)
        else:
            text += str(operator) + str(operand)
    _become(node, prefix, text)


def _replaceAugmented(node: Any) -> None:
    target, _, value = node.children
    text = "%s = %s(%s,%s)" % (str(target).strip(), CALL, str(target).strip(), value)
    _become(node, target.prefix, text)


def _become(node: Any, prefix: str, text: str) -> None:
    leaf_type = next(leaf for leaf in node.leaves())
    leaf = type(leaf_type)(1, text)  # 1: a name, as far as the printing of the tree goes
    leaf.prefix = prefix
    node.replace(leaf)
