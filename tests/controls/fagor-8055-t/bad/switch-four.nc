%0001-A,MX--,
;expected: 4:1 block delete /4: the control has the switches /1 to /3
N10 G71 G90 G94 F100
/4 G1 X10
M30
