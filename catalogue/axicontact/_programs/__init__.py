"""What is evaluated for plain numbers, for blocks of arrays, and over other array libraries; the build writes it.

For `_pressure` of `axicontact/normal/cone.py` there are in `normal/cone.py` of this folder `pressure` for plain
numbers, `prepare_...` and `block_...` for arrays, and below `expressions` the same for any array library.  What
iterates stands below `bodies`, with `math` in the place of NumPy.
"""
