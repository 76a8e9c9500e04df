"""A client that looks through a camera and turns its head: a number of all pictures it has seen."""
import hashlib
import time

from naoqi import ALProxy

RESOLUTION, COLOUR_SPACE, RATE = 3, 13, 15  # 1280x960: more than a socket holds; BGR
video = ALProxy("ALVideoDevice", "127.0.0.1", 9559)
motion = ALProxy("ALMotion", "127.0.0.1", 9559)
handle = video.subscribeCamera("pictures", 0, RESOLUTION, COLOUR_SPACE, RATE)
motion.setStiffnesses("Head", 1.0)
motion.post.angleInterpolation("HeadYaw", [0.5, -0.5], [1.0, 2.0], True)
seen = hashlib.md5()
count, last = 0, None
while count < 8:
    image = video.getImageRemote(handle)
    if (image[4], image[5]) != last:
        last = image[4], image[5]
        count += 1
        seen.update(bytes(image[6]))
    video.releaseImage(handle)
    time.sleep(0.01)
print(seen.hexdigest(), last, time.time())
