"""The figures that tools/house prints."""
