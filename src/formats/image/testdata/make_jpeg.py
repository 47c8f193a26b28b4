"""Writes small JPEGs with Pillow: a red, a green, a blue and a grey square of 16 pixels each; images.test.ts knows them."""

from PIL import Image

image = Image.new("RGB", (32, 32))
for (x, y), color in {(0, 0): (220, 30, 40), (16, 0): (20, 200, 60), (0, 16): (30, 40, 210), (16, 16): (128, 128, 128)}.items():
    image.paste(color, (x, y, x + 16, y + 16))
image.save("squares.jpg", quality=90)
image.save("squares-progressive.jpg", quality=90, progressive=True)
image.convert("L").save("squares-grey.jpg", quality=90)
