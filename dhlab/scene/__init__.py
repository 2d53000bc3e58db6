"""Handles with identity: coordinate systems, blocks and robots that tell their views of changes."""
