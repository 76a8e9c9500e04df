"""A client of two threads that share a proxy each, a lock and a queue."""
import queue
import threading
import time

from naoqi import ALProxy

start = time.monotonic()
seen = queue.Queue()
lock = threading.Lock()
lines = []
stop = threading.Event()


def watch():
    memory = ALProxy("ALMemory", "127.0.0.1", 9559)
    while not stop.wait(0.02):
        angle = memory.getData("Device/SubDeviceList/HeadYaw/Position/Sensor/Value")
        seen.put((time.monotonic() - start, angle))
        with lock:
            lines.append("watched %.4f %r" % (time.monotonic() - start, angle))
            time.sleep(0.001)


watcher = threading.Thread(target=watch)
watcher.start()
motion = ALProxy("ALMotion", "127.0.0.1", 9559)
motion.setStiffnesses("Head", 1.0)
for step in range(30):
    motion.setAngles("HeadYaw", 0.5 if step % 10 < 5 else -0.5, 0.5)
    with lock:
        lines.append("moved %.4f %d" % (time.monotonic() - start, step))
    try:
        lines.append("got %r %r" % seen.get(timeout=0.05))
    except queue.Empty:
        lines.append("nothing")
    time.sleep(0.07)
stop.set()
watcher.join()
print("\n".join(lines))
