%0001-A,MX--,
;expected: 4:15 S900 stands behind M, and the control wants another order (error 0012)
N10 G71 G90 G94 F100 S500 M3
N20 G0 X10 M3 S900
N30 M30
