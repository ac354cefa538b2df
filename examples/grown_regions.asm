; 1 slot, 1000 us of light a frame
; 10 words stored in 2 kernels; 10 executed a frame in 2 launches, 4 us
.target
| # A target of nscc: what the compiler, the checker and the emulator know of a chip.
| # Keys marked (not public) are this project's defaults; they may be left out.
| name = "scamp5"
| kind = "scamp"
| description = "SCAMP-5: global PIX reset, non-destructive read"
|
| [array]                                    # the pixels
| rows = 256                                 # pixels from top to bottom
| cols = 256                                 # pixels from left to right
|
| [registers]                                # of one pixel
| analog = ["A", "B", "C", "D", "E", "F", "NEWS"] # analog registers of one pixel
| analog_scratch = "NEWS"                    # register that every analog sequence overwrites
| # one-bit registers of one pixel
| digital = ["R0", "R1", "R2", "R3", "R4", "R5", "R6", "R7", "R8", "R9", "R10", "R11", "R12"]
| mask = "R0"                                # a word changes `masked` only in pixels where this register is 1
| masked = "R12"                             # the register that `mask` guards; both are "none" on a chip without this
|
| [behaviour]                                # these values are not public: each key has a default
| reset_honours_flag = "no"                  # does rpix reset only where FLAG is 1? "no", "yes" or "unknown" (not public)
| where_reads_flag = false                   # may WHERE read FLAG, which it also writes? (not public)
| where_obeys_flag = false                   # does the analog `where` itself act only where FLAG is 1? (not public)
| or_sources = "any"                         # most sources of an OR or NOR word: "any" or a number (not public)
| where_sources = "any"                      # most sources of a WHERE word: "any" or a number (not public)
|
| [store]
| words = 1024                               # largest number of ICWs in all stored kernels
| tables_count = false                       # do constant kernel tables count against the store? (not public)
|
| [time]
| analog_word_us = 0.2                       # one analog word (not public)
| digital_word_us = 0.1                      # one digital word (not public)
| launch_us = 1.0                            # overhead of one kernel launch (not public)
| wait_us = 1.0                              # the frame loop's own time at a boundary (not public)
| readout_us = 16700.0                       # reading one analog register, or all taps, of the whole array out (not public)
| digital_retention_us = 1500000.0           # time for which a digital register keeps an unwritten bit
|
| [range]
| full_well_e = 30000.0                      # electrons that PIX, or a tap, can hold (not public)
| register_min_e = -30000.0                  # least value of an analog register, below 0 (not public)
| register_max_e = 30000.0                   # largest value of an analog register, above 0 (not public)
| adc_bits = 7                               # bits of the readout
| adc_offset_lsb = 0.0                       # offset added to the converter code of an exposure of 0 (not public)
| readout = "spread"                         # codes of 0 .. full_well_e: spread, all of them (2 x exposure - full well is converted); full, the upper half, for the converter is symmetric around 0; half, 0 to the middle (not public)
|
| [in]                                       # the global value IN that every pixel can compare with; set between kernels
| in_low = -127                              # least value of IN, in steps (not public)
| in_high = 126                              # largest value of IN, in steps (not public)
| in_step_e = "auto"                         # electrons a step of IN; "auto": register_max_e / 127 (not public)
| in_settle_us = 5.0                         # time from setting IN to the first word that reads it (not public)
|
| [neighbours]                               # how words reach the pixels to the north, east, south and west
| sees_neighbours = true                     # do words reach the NEWS, and the digital registers, of neighbours? (not public)
| directed_sources = 2                       # most analog sources of a word that writes or reads a neighbour's NEWS (not public)
| directed_halving = false                   # may a bus2 word read a neighbour's NEWS? (not public)
| news_read_keeps = true                     # does NEWS keep its value when neighbours read it? (not public)
.note class "a"
.note codes "open"
.note level "0"
.note lowering "accumulate"

.source
| # Bright regions that grow from frame to frame: a pixel of medium brightness joins a region if at
| # least three of its eight neighbours belong to it (try `--repeat 12`).
| nsl 3
| frame 1 slots of 1ms
| open when true
|
| outside 0
| kernel around = [[1, 1, 1], [1, 0, 1], [1, 1, 1]]
| state region : bit = 0 kept
| plane bright = exposure > 70%
| plane medium = exposure > 30%
| image joined = agree(region, around)
| next region = bright or medium and joined >= -2
| read region

.wait 1000us

.kernel k0                               ; 8 words, 2.6 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus B, NEWS

.kernel k1                               ; 2 words, 1.4 us; launched at 1
    bus NEWS, A, PIX
    bus A, B, NEWS

.slot 0 k0
.slot 1 k1

.bucket frame
.readout A frame 1

; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0000000000000 0                 ; 0
; a line a code: its shutter, then its fields
.code 0

; images and planes: these words follow the last slot's
; kernel 0, IN at -89
;     all
;     where A, IN
;     MOV R6, FLAG
;     all
; kernel 1, IN at -38
;     where A, IN
;     MOV R7, FLAG
;     all
;     bus A
;     CLR R1, R2, R3, R4
;     SET R1
;     DNEWS0 R8, R5
;     bus B, A
;     WHERE R8
; kernel 2, IN at 30
;     bus B, A, IN
;     CLR R1, R2, R3, R4
;     SET R3
;     DNEWS0 R8, R5
;     all
;     bus A, B, IN
;     WHERE R8
;     bus A, B
;     CLR R1, R2, R3, R4
;     SET R4
;     DNEWS0 R8, R5
;     all
;     bus B, A
;     WHERE R8
;     bus B, A, IN
;     CLR R1, R2, R3, R4
;     SET R1
;     DNEWS0 R9, R8
;     all
;     bus A, B, IN
;     WHERE R9
;     bus A, B
;     CLR R1, R2, R3, R4
;     SET R3
;     DNEWS0 R9, R8
;     all
;     bus B, A
;     WHERE R9
;     bus B, A, IN
;     CLR R1, R2, R3, R4
;     SET R2
;     DNEWS0 R8, R5
;     all
;     bus A, B, IN
;     WHERE R8
;     bus A, B
;     CLR R1, R2, R3, R4
;     SET R1
;     DNEWS0 R9, R8
;     all
;     bus B, A
;     WHERE R9
;     bus B, A, IN
;     CLR R1, R2, R3, R4
;     SET R3
;     DNEWS0 R9, R8
;     all
;     bus A, B, IN
;     WHERE R9
;     bus A, B
;     all
; kernel 3, IN at 45
;     where A, IN
;     MOV R8, FLAG
;     all
;     NOT R9, R7
;     NOT R10, R8
;     NOR R11, R9, R10
;     OR R7, R6, R11
;     MOV R5, R7
; R5 holds region
.pictures
| eyJjb3N0cyI6W1siYnJpZ2h0IiwzLDAuMCwwLjBdLFsibWVkaXVtIiwzLDAuMCwwLjBdLFsiam9pbmVkIiw1NywwLjk0NDg4
| MTg4OTc2Mzc3OTUsMy4wXSxbInJlZ2lvbiIsOCwwLjAsMC4wXV0sImNvdW50X3N0ZXBzIjoxNSwiaXRlbXMiOltbImJyaWdo
| dCIsWyJBYm92ZSIsWyJTb3VyY2UiLCJmcmFtZSJdLDg5XV0sWyJtZWRpdW0iLFsiQWJvdmUiLFsiU291cmNlIiwiZnJhbWUi
| XSwzOF1dLFsiam9pbmVkIixbIkFncmVlbWVudCIsWyJCaXQiLCJyZWdpb24iXSwiYXJvdW5kIl1dXSwia2VybmVscyI6W1si
| YXJvdW5kIixbWzEsMSwxXSxbMSwwLDFdLFsxLDEsMV1dLDFdXSwibGF1bmNoZXMiOltbMCwtODldLFsxLC0zOF0sWzIsMzBd
| LFszLDQ1XV0sImxpbWl0c19lIjp7ImZyYW1lIjozMDAwMC4wfSwib3V0c2lkZSI6MCwicmVhZHMiOlsicmVnaW9uIl0sInJl
| Z2lzdGVycyI6eyJyZWdpb24iOiJSNSJ9LCJyZXBvcnRzIjpbXSwic3RhdGVzIjpbWyJyZWdpb24iLDAsWyJKb2luZWQiLCJv
| ciIsWyJCaXQiLCJicmlnaHQiXSxbIkpvaW5lZCIsImFuZCIsWyJCaXQiLCJtZWRpdW0iXSxbIkV4Y2VlZHMiLFsiU291cmNl
| Iiwiam9pbmVkIl0sLTMsMV1dXV1dLCJ3b3JkcyI6W1tbMjA0OCw2OTYzMiwxMzEwNzIsMjA0ODAwLDI2MjE0NF0sWzMyLDY1
| NTg0LDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbNTI0Mzg0LDY1NTM2LDEzMTA3MiwyNTM5NTQsMjYyMTQ0XSxbMjA0OCw2OTYz
| MiwxMzEwNzIsMjA0ODAwLDI2MjE0NF1dLFtbMzIsNjU1ODQsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFs1MjQzODQsNjU1MzYs
| MTMxMDcyLDI1Mzk1NiwyNjIxNDRdLFsyMDQ4LDY5NjMyLDEzMTA3MiwyMDQ4MDAsMjYyMTQ0XSxbODE5Miw2NTU2OCwxMzEw
| NzIsMTk2NjA4LDI2MjE0NF0sWzUyNDMyMCw2NTUzNiwxOTI1MTIsMjUzOTUyLDI2MjE0NF0sWzUyNDMyMCw2NTUzNiwxMzUx
| NjgsMjAwNzA0LDI2MjE0NF0sWzEwNTA2NTYsOTgzMDQsMTMxMDg4LDIyMzI0MCwyNjIxNDRdLFsxNjM4NCw2NTYzMiwxMzEw
| NzIsMTk2NjA4LDI2MjE0NF0sWzUyNjMzNiw2NTU1MiwxMzEyMDAsMjA0ODAwLDI2MjE0NF1dLFtbMTY0MTYsNjU2MzIsMTMx
| MDcyLDE5NjYwOCwyNjIxNDRdLFs1MjQzMjAsNjU1MzYsMTkyNTEyLDI1Mzk1MiwyNjIxNDRdLFs1MjQzMjAsNjU1MzYsMTQ3
| NDU2LDIwMDcwNCwyNjIxNDRdLFsxMDUwNjU2LDk4MzA0LDEzMTA4OCwyMjMyNDAsMjYyMTQ0XSxbMjA0OCw2OTYzMiwxMzEw
| NzIsMjA0ODAwLDI2MjE0NF0sWzgyMjQsNjU2MzIsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFs1MjYzMzYsNjU1NTIsMTMxMjAw
| LDIwNDgwMCwyNjIxNDRdLFs4MTkyLDY1NjMyLDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbNTI0MzIwLDY1NTM2LDE5MjUxMiwy
| NTM5NTIsMjYyMTQ0XSxbNTI0MzIwLDY1NTM2LDE2Mzg0MCwyMDA3MDQsMjYyMTQ0XSxbMTA1MDY1Niw5ODMwNCwxMzEwODgs
| MjIzMjQwLDI2MjE0NF0sWzIwNDgsNjk2MzIsMTMxMDcyLDIwNDgwMCwyNjIxNDRdLFsxNjM4NCw2NTYzMiwxMzEwNzIsMTk2
| NjA4LDI2MjE0NF0sWzUyNjMzNiw2NTU1MiwxMzEyMDAsMjA0ODAwLDI2MjE0NF0sWzE2NDE2LDY1NjMyLDEzMTA3MiwxOTY2
| MDgsMjYyMTQ0XSxbNTI0MzIwLDY1NTM2LDE5MjUxMiwyNTM5NTIsMjYyMTQ0XSxbNTI0MzIwLDY1NTM2LDEzNTE2OCwyMDA3
| MDQsMjYyMTQ0XSxbMTA1MDY1Niw5ODMwNCwxMzEyMDAsMjIzMjQ4LDI2MjE0NF0sWzIwNDgsNjk2MzIsMTMxMDcyLDIwNDgw
| MCwyNjIxNDRdLFs4MjI0LDY1NjMyLDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbNTI2MzM2LDY1NTUyLDEzMTMyOCwyMDQ4MDAs
| MjYyMTQ0XSxbODE5Miw2NTYzMiwxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzUyNDMyMCw2NTUzNiwxOTI1MTIsMjUzOTUyLDI2
| MjE0NF0sWzUyNDMyMCw2NTUzNiwxNDc0NTYsMjAwNzA0LDI2MjE0NF0sWzEwNTA2NTYsOTgzMDQsMTMxMjAwLDIyMzI0OCwy
| NjIxNDRdLFsyMDQ4LDY5NjMyLDEzMTA3MiwyMDQ4MDAsMjYyMTQ0XSxbMTYzODQsNjU2MzIsMTMxMDcyLDE5NjYwOCwyNjIx
| NDRdLFs1MjYzMzYsNjU1NTIsMTMxMzI4LDIwNDgwMCwyNjIxNDRdLFsxNjQxNiw2NTYzMiwxMzEwNzIsMTk2NjA4LDI2MjE0
| NF0sWzUyNDMyMCw2NTUzNiwxOTI1MTIsMjUzOTUyLDI2MjE0NF0sWzUyNDMyMCw2NTUzNiwxMzkyNjQsMjAwNzA0LDI2MjE0
| NF0sWzEwNTA2NTYsOTgzMDQsMTMxMDg4LDIyMzI0MCwyNjIxNDRdLFsyMDQ4LDY5NjMyLDEzMTA3MiwyMDQ4MDAsMjYyMTQ0
| XSxbODIyNCw2NTYzMiwxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzUyNjMzNiw2NTU1MiwxMzEyMDAsMjA0ODAwLDI2MjE0NF0s
| WzgxOTIsNjU2MzIsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFs1MjQzMjAsNjU1MzYsMTkyNTEyLDI1Mzk1MiwyNjIxNDRdLFs1
| MjQzMjAsNjU1MzYsMTM1MTY4LDIwMDcwNCwyNjIxNDRdLFsxMDUwNjU2LDk4MzA0LDEzMTIwMCwyMjMyNDgsMjYyMTQ0XSxb
| MjA0OCw2OTYzMiwxMzEwNzIsMjA0ODAwLDI2MjE0NF0sWzE2Mzg0LDY1NjMyLDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbNTI2
| MzM2LDY1NTUyLDEzMTMyOCwyMDQ4MDAsMjYyMTQ0XSxbMTY0MTYsNjU2MzIsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFs1MjQz
| MjAsNjU1MzYsMTkyNTEyLDI1Mzk1MiwyNjIxNDRdLFs1MjQzMjAsNjU1MzYsMTQ3NDU2LDIwMDcwNCwyNjIxNDRdLFsxMDUw
| NjU2LDk4MzA0LDEzMTIwMCwyMjMyNDgsMjYyMTQ0XSxbMjA0OCw2OTYzMiwxMzEwNzIsMjA0ODAwLDI2MjE0NF0sWzgyMjQs
| NjU2MzIsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFs1MjYzMzYsNjU1NTIsMTMxMzI4LDIwNDgwMCwyNjIxNDRdLFs4MTkyLDY1
| NjMyLDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbMjA0OCw2OTYzMiwxMzEwNzIsMjA0ODAwLDI2MjE0NF1dLFtbMzIsNjU1ODQs
| MTMxMDcyLDE5NjYwOCwyNjIxNDRdLFs1MjQzODQsNjU1MzYsMTMxMDcyLDI1Mzk2MCwyNjIxNDRdLFsyMDQ4LDY5NjMyLDEz
| MTA3MiwyMDQ4MDAsMjYyMTQ0XSxbNTI0MzIwLDY1NTM2LDEzMTEzNiwyNDI3MDQsMjYyMTQ0XSxbNTI0MzIwLDY1NTM2LDEz
| MTIwMCwyNDI3MjAsMjYyMTQ0XSxbNTI0MzIwLDY1NTM2LDEzMTg0MCwyNDI3NTIsMjYyMTQ0XSxbNTI0MzIwLDY1NTM2LDEz
| MjEyOCwyNTM5NTYsMjYyMTQ0XSxbNTI0MzIwLDY1NTM2LDEzMTEzNiwyNTM5NTMsMjYyMTQ0XV1dfQ==

; the code of every pixel
.pixels tile 1 1
| 0
