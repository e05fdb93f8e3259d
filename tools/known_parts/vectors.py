"""Vectors in space as tuples of three numbers."""

import math


def add(*vectors):
    return tuple(sum(c) for c in zip(*vectors))


def sub(a, b):
    return tuple(p - q for p, q in zip(a, b))


def scale(a, factor):
    return tuple(c * factor for c in a)


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return scale(a, 1.0 / math.hypot(*a))


def combine(*terms):
    """The sum of factor × vector over pairs (factor, vector)."""
    return add(*(scale(vector, factor) for factor, vector in terms))


def turned(a, axis, angle):
    """`a` turned about the unit vector `axis`, counter-clockwise seen from its tip."""
    c, s = math.cos(angle), math.sin(angle)
    return combine((c, a), (s, cross(axis, a)), ((1 - c) * dot(axis, a), axis))
