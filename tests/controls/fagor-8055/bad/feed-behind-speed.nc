%0001-A,MX--,
;expected: 4:17 F200 stands behind S, and the control wants another order (error 0003)
N10 G71 G90 G94 F100 S500 M3
N20 G1 X10 S900 F200
N30 M30
