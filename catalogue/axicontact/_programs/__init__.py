"""What is evaluated for plain numbers, blocks of arrays and other array libraries, written by the build.

For `_pressure` of `axicontact/normal/cone.py` there are in `normal/cone.py` of this folder `pressure` for plain
numbers, `prepare_...` and `block_...` for arrays, and below `expressions` the same for any array library.  What
iterates stands below `bodies`, with `math` in the place of NumPy.
"""
