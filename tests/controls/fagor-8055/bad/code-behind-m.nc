%0001-A,MX--,
;expected: 4:8 G0 stands behind M, and the control wants another order; write
N10 G71 G90 G94 F100 S500 M3
N20 M5 G0 X10
N30 M30
