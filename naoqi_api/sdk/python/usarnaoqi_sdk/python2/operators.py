"""Python 2's operators: `a / b` of whole numbers, and `a < b` of what Python 3 does not compare,
become calls that do as it did; so do methods of what was text and bytes alike. Names that are
keywords now get another one."""

import ast
from typing import Any

NAME, STRING = 1, 3  # lib2to3's numbers of tokens
DIVIDE = "py2_divide"
METHODS = {"." + name: "py2_" + name for name in (
    "decode", "encode", "join", "next", "sort", "translate")}
# Of files, sockets and libraries: text and bytes were one.
METHODS.update({"." + name: "py2_call" for name in (
    "adler32", "array", "b64decode", "b64encode", "communicate", "compress", "crc32",
    "decodestring", "decompress", "encodestring", "frombuffer", "frombytes", "fromstring",
    "hexlify", "loads", "md5", "new", "pack", "read", "readline", "readlines", "recv", "recvfrom",
    "send", "sendall", "sendto", "sha1", "sha256", "sha512", "tobytes", "tostring", "unhexlify",
    "unpack", "unpack_from", "update", "urlsafe_b64decode", "urlsafe_b64encode", "write")})
METHODS.update({".dump": "py2_pickle", ".load": "py2_pickle", ".Popen": "py2_process",
                ".check_output": "py2_process"})
NAMED = {"py2_call", "py2_pickle", "py2_process"}  # are told which method is meant
NEW_KEYWORDS = {"async", "await"}
COMPARE = {"<": "py2_less", ">": "py2_greater", "<=": "py2_less_equal", ">=": "py2_greater_equal"}
CHAINED = frozenset(COMPARE) | {"==", "!="}


def translated(tree: Any, text: str) -> str:
    """The text of a tree of lib2to3's, its operators replaced."""
    for leaf in tree.leaves():
        if leaf.type == NAME and leaf.value in NEW_KEYWORDS:
            leaf.value += "_"
        elif leaf.type == STRING and leaf.value[0] in "bB" and _isAlone(leaf):
            leaf.value = "py2_bytes(%s)" % leaf.value
    _visit(tree, "import division" not in text)
    return str(tree)


def _isAlone(leaf: Any) -> bool:
    """Of strings side by side none is called."""
    return not any(other and other.type == STRING
                   for other in (leaf.prev_sibling, leaf.next_sibling))


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
    elif set(operators) & set(COMPARE) and set(operators) <= CHAINED:
        _replaceChain(node)
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
            text = _call(str(node.children[at]).strip(), text, str(node.children[at + 1])[1:-1])
            at += 2
        else:
            text += str(node.children[at])
            at += 1
    _become(node, prefix, text)


def _call(method: str, value: str, arguments: str) -> str:
    function = METHODS[method]
    first = value + (', "%s"' % method[1:] if function in NAMED else "")
    if not arguments.strip():
        return "%s(%s)" % (function, first)
    if _isGenerator(arguments):
        arguments = "(%s)" % arguments
    return "%s(%s, %s)" % (function, first, arguments)


def _isGenerator(arguments: str) -> bool:
    """A lone one, which needs parentheses beside another argument."""
    if " for " not in arguments.replace("\n", " "):
        return False
    try:
        call: Any = ast.parse("f(%s)" % arguments, mode="eval").body
    except SyntaxError:
        return False
    return len(call.args) == 1 and isinstance(call.args[0], ast.GeneratorExp) and \
        not arguments.strip().startswith("(")


def _replaceComparison(node: Any, name: str) -> None:
    """Of two."""
    first, _, second = node.children
    prefix = first.prefix
    _become(node, prefix, "%s(%s,%s)" % (name, str(first)[len(prefix):], second))


def _replaceChain(node: Any) -> None:
    """Of more; each but the first is only looked at if those before it hold."""
    first = node.children[0]
    prefix = first.prefix
    rest = "".join(', "%s", lambda: %s' % (str(operator).strip(), operand)
                   for operator, operand in zip(node.children[1::2], node.children[2::2]))
    _become(node, prefix, "py2_chain(%s%s)" % (str(first)[len(prefix):], rest))


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
    leaf = type(leaf_type)(NAME, text)  # as far as the printing of the tree goes
    leaf.prefix = prefix
    node.replace(leaf)
