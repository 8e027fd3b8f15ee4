%P
G71 G90 G94 F100
N10 G0 X10 Y10 (initial point)
N20 G1 X20 (end)
M30
