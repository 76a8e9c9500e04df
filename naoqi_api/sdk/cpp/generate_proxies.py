"""Writes alproxies/<service>proxy.h for every service that `usarnaoqi describe --services --json`
tells of: a class with each method and, as .post, each method that does not wait.

    usarnaoqi describe --services --json | python3 generate_proxies.py FOLDER
"""

import json
import os
import re
import sys

FIRST_OWN = 113  # below: what all modules have, which ALProxy offers
TYPES = {"v": "void", "b": "bool", "i": "int", "I": "int", "w": "int", "W": "int", "c": "int",
         "C": "int", "f": "float", "d": "double", "s": "std::string", "m": "ALValue",
         "r": "ALValue"}
OF_ALL = {"wait", "isRunning", "stop", "exit", "ping", "version", "call", "callVoid", "pCall"}
KEYWORDS = {"delete", "new", "register", "switch", "default", "class", "template", "operator",
            "private", "public", "this", "union", "export", "import", "continue", "break"}

# What is no call alone: an image or a number that a program of the same process has a pointer to.
LOCAL = {
    "ALVideoDevice": {
        "getImageLocal": ("void*", "return detail::localImage(*this, {0}, false)"),
        "getDirectRawImageLocal": ("void*", "return detail::localImage(*this, {0}, true)"),
        "releaseImage": ("bool", "detail::releaseLocalImage({0}, false); "
                                 "return call<bool>(\"releaseImage\", {0})"),
        "releaseDirectRawImage": ("bool", "detail::releaseLocalImage({0}, true); "
                                          "return call<bool>(\"releaseDirectRawImage\", {0})")},
    "ALMemory": {"getDataPtr": ("void*", "return detail::memoryPointer(*this, {0})")}}
LOCAL_HEADERS = {"ALVideoDevice": "local_image.h", "ALMemory": "memory_pointer.h"}

# Where what the daemon says of a method is not what the proxy does.
MEANINGS = {("ALMemory", "getDataPtr"): "The key's int or float, as it is in each cycle: in a local "
            "module only. @throws ALError elsewhere, or for a key that has no number."}

HEADER = """#pragma once

// Made from the declarations of {service}; do not edit.

#include <string>
#include <vector>

#include <alcommon/alproxy.h>{more}

namespace AL {{

class {service}Proxy;

/// The methods of {service} without waiting: each returns an id for wait(), isRunning(), stop().
class {service}ProxyPostHandler {{
 public:
  explicit {service}ProxyPostHandler(boost::shared_ptr<ALProxy> proxy) : proxy_(proxy) {{}}
{posts}
 private:
  boost::shared_ptr<ALProxy> proxy_;
}};

/// {meaning}
class {service}Proxy : public ALProxy {{
 public:
  /// Of the robot that this program's first broker is connected to. @throws ALError without one
  {service}Proxy() : ALProxy("{service}"), post(getGenericProxy()) {{}}
  explicit {service}Proxy(const std::string& ip, int port = kDefaultPort)
      : ALProxy("{service}", ip, port), post(getGenericProxy()) {{}}
  explicit {service}Proxy(boost::shared_ptr<ALBroker> broker, int = 0, int = 0)
      : ALProxy(broker, "{service}"), post(getGenericProxy()) {{}}
  explicit {service}Proxy(boost::shared_ptr<ALProxy> proxy)
      : ALProxy(proxy), post(getGenericProxy()) {{}}
  static const char* getSpecialisedProxyName() {{ return "{service}"; }}
{methods}
  {service}ProxyPostHandler post;
}};

}}  // namespace AL
"""


def typesOf(signature):
    """The C++ types of a tuple's items, or None where one has none."""
    types, at = [], 1
    while at < len(signature) - 1:
        depth = 0
        while signature[at] == "[":
            depth, at = depth + 1, at + 1
        name = TYPES.get(signature[at])
        at += 1 + depth
        if name is None or name == "void":
            return None
        for _ in range(depth):
            name = "std::vector<%s >" % name
        types.append(name)
    return types


def nameOf(argument, number):
    """A parameter's name in C++: what NaoQi calls it, if that is one word."""
    name = argument.get("name", "") if argument else ""
    return "p" + name[0].upper() + name[1:] if re.fullmatch(r"[A-Za-z]\w*", name) else "p%d" % number


def parametersOf(method):
    types = typesOf(method["parameters"])
    if types is None:
        return None
    told = method["arguments"] + [None] * len(types)
    names = [nameOf(told[i], i + 1) for i in range(len(types))]
    if len(set(names)) < len(names):
        names = ["p%d" % (i + 1) for i in range(len(types))]
    return list(zip(types, names))


def comment(text):
    return "  /// " + " ".join(text.split()).replace("*/", "* /") if text.strip() else ""


def methodText(service, method, parameters, returned):
    declared = ", ".join("const %s& %s" % one for one in parameters)
    passed = ", ".join(name for _, name in parameters)
    call = '"%s"%s' % (method["name"], ", " + passed if passed else "")
    body = "callVoid(%s)" % call if returned == "void" else "return call<%s>(%s)" % (returned, call)
    if method["name"] in LOCAL.get(service, {}):
        returned, body = LOCAL[service][method["name"]]
        body = body.format(passed)
    told = comment(MEANINGS.get((service, method["name"]), method["meaning"]))
    return (told + "\n" if told else "") + \
        "  %s %s(%s) const { %s; }\n" % (returned, method["name"], declared, body)


def postText(method, parameters):
    declared = ", ".join("const %s& %s" % one for one in parameters)
    passed = "".join(", " + name for _, name in parameters)
    return '  int %s(%s) const { return proxy_->pCall("%s"%s); }\n' % (
        method["name"], declared, method["name"], passed)


def isOwn(method):
    name = method["name"]
    own = method["uid"] >= FIRST_OWN and not name.startswith("_") and name not in KEYWORDS
    return own and (name not in OF_ALL or method["parameters"] not in ("(ii)", "(i)", "()"))


def headerOf(service):
    methods, posts, known = "", "", set()
    for method in filter(isOwn, service["methods"]):
        parameters = parametersOf(method)
        returned = typesOf("(%s)" % method["returns"]) if method["returns"] != "v" else ["void"]
        if method["name"] in LOCAL.get(service["name"], {}):
            returned = ["ALValue"]  # which methodText() replaces
        if parameters is None or not returned:
            continue
        shape = (method["name"], tuple(kind for kind, _ in parameters))
        if shape in known:
            continue
        known.add(shape)
        methods += methodText(service["name"], method, parameters, returned[0])
        posts += postText(method, parameters)
    return HEADER.format(service=service["name"], meaning=" ".join(service["meaning"].split()),
                         methods=methods, posts=posts,
                         more="\n#include <usarnaoqi_sdk/%s>" % LOCAL_HEADERS[service["name"]]
                         if service["name"] in LOCAL_HEADERS else "")


def writeIfNew(path, text):
    """So that what includes the file is not compiled again without need."""
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            if file.read() == text:
                return
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def main():
    folder = os.path.join(sys.argv[1], "alproxies")
    os.makedirs(folder, exist_ok=True)
    for service in json.load(sys.stdin)["services"]:
        path = os.path.join(folder, service["name"].lower() + "proxy.h")
        writeIfNew(path, headerOf(service))


if __name__ == "__main__":
    main()
