// A small client for pages that use a robot: the names of qi.js, on browsers' own WebSocket.
//
//   QiSession(function (session) {
//     session.service("ALTextToSpeech").then(function (tts) { return tts.say("Hello"); });
//   }, function () { console.log("disconnected"); }, "localhost:8002");
//
// A method returns a promise of its result. A signal has connect(callback), whose promise is a
// link, and disconnect(link); a property also value() and setValue(value).

"use strict";

function QiSession(connected, disconnected, host) {
  const session = {};
  const calls = new Map(); // by number: {resolve, reject}
  const listeners = new Map(); // by object, signal and link: callback
  let lastCall = 0;
  let socket = null;

  function call(object, member, args) {
    return new Promise(function (resolve, reject) {
      if (!socket || socket.readyState !== WebSocket.OPEN) {
        reject("not connected");
        return;
      }
      calls.set(++lastCall, { resolve: resolve, reject: reject });
      const params = { obj: object, member: member, args: args };
      const event = { name: "call", args: [{ idm: lastCall, params: params }] };
      socket.send("5:::" + JSON.stringify(event));
    });
  }

  function keyOf(object, signal, link) {
    return object + "/" + signal + "/" + link;
  }

  function makeSignal(object, name) {
    return {
      connect: function (callback) {
        return call(object, name, ["connect"]).then(function (link) {
          listeners.set(keyOf(object, name, link), callback);
          return link;
        });
      },
      disconnect: function (link) {
        listeners.delete(keyOf(object, name, link));
        return call(object, name, ["disconnect", link]);
      },
    };
  }

  function makeProperty(object, name) {
    const property = makeSignal(object, name);
    property.value = function () {
      return call(object, name, ["value"]);
    };
    property.setValue = function (value) {
      return call(object, name, ["setValue", value]);
    };
    return property;
  }

  function makeObject(object, offer) {
    const made = { __MetaObject: offer };
    Object.values(offer.methods).forEach(function (method) {
      made[method.name] = function () {
        return call(object, method.name, Array.from(arguments));
      };
    });
    Object.values(offer.signals).forEach(function (signal) {
      made[signal.name] = makeSignal(object, signal.name);
    });
    Object.values(offer.properties).forEach(function (property) {
      made[property.name] = makeProperty(object, property.name);
    });
    return made;
  }

  // Objects may stand anywhere in a result.
  function revive(value) {
    if (value === null || typeof value !== "object") return value;
    if ("pyobject" in value && "metaobject" in value) {
      return makeObject(value.pyobject, value.metaobject);
    }
    Object.keys(value).forEach(function (key) {
      value[key] = revive(value[key]);
    });
    return value;
  }

  function takeAnswer(name, answer) {
    const call = calls.get(answer.idm);
    if (!call) return;
    calls.delete(answer.idm);
    if (name === "error") call.reject(answer.result);
    else call.resolve(revive(answer.result));
  }

  function takeSignal(event) {
    const callback = listeners.get(keyOf(event.obj, event.signal, event.link));
    if (callback) callback.apply(null, revive(event.data));
  }

  function take(text) {
    if (text.startsWith("2::")) socket.send("2::");
    if (text.startsWith("1::") && connected) connected(session);
    if (!text.startsWith("5:::")) return;
    const event = JSON.parse(text.slice(4));
    const content = Array.isArray(event.args) ? event.args[0] : event.args;
    if (event.name === "signal") takeSignal(content.result);
    else takeAnswer(event.name, content);
  }

  function gone() {
    calls.forEach(function (call) {
      call.reject("disconnected");
    });
    calls.clear();
    listeners.clear();
    if (disconnected) disconnected();
  }

  session.service = function (name) {
    return call("ServiceDirectory", "service", [name]).then(function (service) {
      if (service === null) throw "there is no service " + name;
      return service;
    });
  };
  session.disconnect = function () {
    if (socket) socket.close();
  };

  const place = host || window.location.host;
  const path = "//" + place + "/libs/qimessaging/2/socket.io/1/";
  fetch("http:" + path + "?t=" + Date.now(), { credentials: "include" })
    .then(function (answer) {
      if (!answer.ok) throw answer.status;
      return answer.text();
    })
    .then(function (handshake) {
      socket = new WebSocket("ws:" + path + "websocket/" + handshake.split(":")[0]);
      socket.onmessage = function (message) {
        take(message.data);
      };
      socket.onclose = gone;
    })
    .catch(gone);
  return session;
}

if (typeof module !== "undefined") module.exports = { QiSession: QiSession };
