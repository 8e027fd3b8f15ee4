%0001-A,MX--,
;expected: 4:11 Y2 stands behind Z, and the control wants another order (error 0048); write the words of the block in the order G, X Y Z U V W A B C, F S T D, M
N10 G71 G90 G94 F100 S500 M3
N20 G0 Z1 Y2
N30 M30
