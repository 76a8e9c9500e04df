"""A client of a world that it sets back, pauses and steps: its own clock goes on."""
import time

from naoqi import ALProxy

world = ALProxy("UsarSim", "127.0.0.1", 9559)
start = time.time()


def tell(what):
    print("%s: %.2f s here, %.2f s there" % (what, time.time() - start, world.time()))


time.sleep(1)
tell("slept")
world.snapshot("then")
time.sleep(1)
world.restore("then")
tell("set back")
world.pause()
time.sleep(1)
tell("paused")
world.step(50)
tell("stepped")
world.resume()
time.sleep(1)
tell("resumed")
