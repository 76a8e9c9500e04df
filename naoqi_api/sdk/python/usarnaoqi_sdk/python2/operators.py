"""Python 2's operators: `a / b` of whole numbers, and `a < b` of what Python 3 does not compare,
become calls that do as it did; so do the methods that its strings had for both text and bytes."""

from typing import Any

DIVIDE = "py2_divide"
METHODS = {".decode": "py2_decode", ".encode": "py2_encode"}
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
    if any(_isMethod(node, at) for at in range(1, len(node.children) - 1)):
        return _replaceMethods(node)
    operators = [str(child).strip() for child in node.children[1::2]]
    if len(node.children) == 3 and operators[0] in COMPARE:
        _replaceComparison(node, COMPARE[operators[0]])
    elif divides and "/" in operators and _isTerm(node):
        _replace(node)
    elif divides and len(node.children) == 3 and operators[0] == "/=":
        _replaceAugmented(node)


def _isMethod(node: Any, at: int) -> bool:
    """Whether `.decode` stands there, called behind."""
    method, call = node.children[at], node.children[at + 1]
    return str(method).strip() in METHODS and str(call).startswith("(")


def _replaceMethods(node: Any) -> None:
    prefix = node.prefix
    text, at = str(node.children[0])[len(prefix):], 1
    while at < len(node.children):
        if at + 1 < len(node.children) and _isMethod(node, at):
            arguments = str(node.children[at + 1])[1:-1]
            name = METHODS[str(node.children[at]).strip()]
            text = "%s(%s%s)" % (name, text, ", " + arguments if arguments.strip() else "")
            at += 2
        else:
            text += str(node.children[at])
            at += 1
    _become(node, prefix, text)


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
