"""Exercises that say why, and the marking of a class."""
