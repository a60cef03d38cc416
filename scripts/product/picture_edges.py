# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges of a picture as strokes on white, to compare lines on surfaces with.

    picture_edges.py log|canny SIGMA WIDTH INPUT.png OUTPUT.png

SIGMA is the standard deviation of the blur, WIDTH that of the strokes, both in pixels. log draws the zero crossings of
the Laplacian of the Gaussian, canny Canny's edges, both by scikit-image and SciPy. Thresholds are slopes within SIGMA,
as a share of what is between black and white, of which MeshLab's shading takes less than half: so they do not depend
on the size of the picture.
"""
import sys

import numpy
from scipy import ndimage
from skimage import feature, io, util

LEAST_SLOPE = 0.02  # of a zero crossing
WEAK_SLOPE, STRONG_SLOPE = 0.012, 0.03  # Canny's hysteresis
SOBEL = 8  # what scikit-image's Sobel filter makes of a slope of 1 a pixel


def zero_crossings(shading, sigma):
    """Pixels whose right or lower neighbour has the other sign, where the shading is steep enough."""
    laplacian = ndimage.gaussian_laplace(shading, sigma, mode="nearest")
    slope = sigma * ndimage.gaussian_gradient_magnitude(shading, sigma, mode="nearest")
    positive = laplacian > 0
    crossing = numpy.zeros_like(positive)
    crossing[:-1] |= positive[:-1] != positive[1:]
    crossing[:, :-1] |= positive[:, :-1] != positive[:, 1:]
    return crossing & (slope > LEAST_SLOPE)


def canny_edges(shading, sigma):
    thresholds = [SOBEL * slope / sigma for slope in (WEAK_SLOPE, STRONG_SLOPE)]
    return feature.canny(shading, sigma, *thresholds, mode="nearest")


DETECTORS = {"log": zero_crossings, "canny": canny_edges}


def strokes(edges, width):
    """Paper, 255, with ink within half an edge's width of an edge's pixel."""
    if not edges.any():
        return numpy.full(edges.shape, 255, numpy.uint8)
    distance = ndimage.distance_transform_edt(~edges)
    return numpy.uint8(255 * numpy.clip(distance - (width - 1) / 2, 0, 1))


def main():
    detector, sigma, width, source, target = sys.argv[1:]
    shading = util.img_as_float(io.imread(source, as_gray=True))
    edges = DETECTORS[detector](shading, float(sigma))
    io.imsave(target, strokes(edges, float(width)), check_contrast=False)


main()
