#!/usr/bin/env python3
"""Takes a picture with the top camera and saves it as image.ppm, which any viewer opens."""

import sys

from naoqi import ALProxy
from vision_definitions import kRGBColorSpace, kTopCamera, kVGA

ip = sys.argv[1] if len(sys.argv) > 1 else "127.0.0.1"
port = int(sys.argv[2]) if len(sys.argv) > 2 else 9559

video = ALProxy("ALVideoDevice", ip, port)
handle = video.subscribeCamera("grab_image", kTopCamera, kVGA, kRGBColorSpace, 10)  # 10 images/s
try:
    width, height, _, _, seconds, microseconds, pixels = video.getImageRemote(handle)[:7]
    video.releaseImage(handle)
finally:
    video.unsubscribe(handle)

with open("image.ppm", "wb") as file:
    file.write(b"P6 %d %d 255\n" % (width, height) + pixels)
print("image.ppm: %d x %d, taken at %d.%06d s" % (width, height, seconds, microseconds))
