; 16 slots, 2000 us of light a frame
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
| tables_count = true                        # do constant kernel tables count against the store? (not public)
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
| adc_bits = 8                               # bits of the readout
| adc_offset_lsb = 0.0                       # offset added to the converter code of an exposure of 0 (not public)
| readout = "spread"                         # codes of 0 .. full_well_e: spread, all of them (2 x exposure - full well is converted); full, the upper half, for the converter is symmetric around 0; half, 0 to the middle (not public)
|
| [in]                                       # the global value IN that every pixel can compare with; set between kernels
| in_low = -127                              # least value of IN, in steps (not public)
| in_high = 126                              # largest value of IN, in steps (not public)
| in_step_e = "auto"                         # electrons a step of IN; "auto": register_max_e / 127 (not public)
| in_settle_us = 5000.0                      # time from setting IN to the first word that reads it (not public)
|
| [neighbours]                               # how words reach the pixels to the north, east, south and west
| sees_neighbours = true                     # do words reach the NEWS, and the digital registers, of neighbours? (not public)
| directed_sources = 2                       # most analog sources of a word that writes or reads a neighbour's NEWS (not public)
| directed_halving = false                   # may a bus2 word read a neighbour's NEWS? (not public)
| news_read_keeps = true                     # does NEWS keep its value when neighbours read it? (not public)
.note class "a"
.note codes "open"
.note level "0"
.note lowering "latch"

.source
| # Edges in the pixels: the absolute values of two Sobel kernels, added up and compared with a level.
| # Only the plane of bits leaves the chip.
| nsl 3
| frame 16 slots of 125us
| open when true
|
| kernel sx = [[1, 0, -1], [2, 0, -2], [1, 0, -1]] / 8
| kernel sy = [[1, 2, 1], [0, 0, 0], [-1, -2, -1]] / 8
| image strength = abs(sx(exposure)) + abs(sy(exposure))  # 0 .. one full well
| plane edge = strength > 6%
| read edge

.wait 125us x16

.kernel k0                               ; 8 words, 2.6 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus B, NEWS

.kernel k1                               ; 2 words, 1.4 us; launched at 16
    bus NEWS, PIX
    bus A, B, NEWS

.slot 0 k0
.slot 16 k1

.bucket frame
.readout A frame 1

; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0000000000000 0..15             ; 0
; a line a code: its shutter, then its fields
.code 0

; images and planes: these words follow the last slot's
; kernel 0, IN at 8
;     all
;     bus XN, A
;     bus2 B, C, A, NEWS
;     bus2 NEWS, D, A, B
;     bus E, D, XN
;     bus2 NEWS, F, E
;     bus E, XE
;     bus F, E, XW
;     bus NEWS, F
;     bus E, F
;     where F
;     bus E, NEWS
;     all
;     bus XW, A
;     bus2 B, F, A, NEWS
;     bus2 B, NEWS, A, F
;     bus A, B, XW
;     bus2 B, NEWS, A
;     bus A, XS
;     bus B, A, XN
;     bus NEWS, B
;     bus A, B
;     where B
;     bus A, NEWS
;     all
;     bus B, A, E
;     where B, IN
;     NOT R1, FLAG
;     all
; R1 holds edge
.pictures
| eyJjb3N0cyI6W1sic3RyZW5ndGgiLDI1LDEuMCw0LjA3NzM3NjYwNzU3NTAyMl0sWyJlZGdlIiwzLDAuMCwwLjBdXSwiaXRl
| bXMiOltbInN0cmVuZ3RoIixbIlN1bSIsWzEsMSxbIkFic29sdXRlIixbIkZpbHRlcmVkIiwic3giLFsiU291cmNlIiwiZnJh
| bWUiXV1dXSxbMSwxLFsiQWJzb2x1dGUiLFsiRmlsdGVyZWQiLCJzeSIsWyJTb3VyY2UiLCJmcmFtZSJdXV1dXV0sWyJlZGdl
| IixbIkFib3ZlIixbIlNvdXJjZSIsInN0cmVuZ3RoIl0sOF1dXSwia2VybmVscyI6W1sic3giLFtbMSwwLC0xXSxbMiwwLC0y
| XSxbMSwwLC0xXV0sOF0sWyJzeSIsW1sxLDIsMV0sWzAsMCwwXSxbLTEsLTIsLTFdXSw4XV0sImxhdW5jaGVzIjpbWzAsOF1d
| LCJsaW1pdHNfZSI6eyJmcmFtZSI6MzAwMDAuMH0sIm91dHNpZGUiOm51bGwsInJlYWRzIjpbImVkZ2UiXSwicmVnaXN0ZXJz
| Ijp7ImVkZ2UiOiJSMSJ9LCJyZXBvcnRzIjpbXSwid29yZHMiOltbWzIwNDgsNjk2MzIsMTMxMDcyLDIwNDgwMCwyNjIxNDRd
| LFsxMjgsNjU4MjUsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFs1MDE3Niw2NjAxNiwxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzEw
| MjQsNjY0MDMsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFsxMjgsNjczMzIsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFsxMDI0LDY4
| ODczLDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbNTEyLDY2ODIwLDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbMCw3NzA2NCwxMzEw
| NzIsMTk2NjA4LDI2MjE0NF0sWzEwMjQsNjc4NDEsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFswLDY4NjEyLDEzMTA3MiwxOTY2
| MDgsMjYyMTQ0XSxbMCw2NzYwMCwxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzEwMjQsNjY4MjAsMTMxMDcyLDE5NjYwOCwyNjIx
| NDRdLFsyMDQ4LDY5NjMyLDEzMTA3MiwyMDQ4MDAsMjYyMTQ0XSxbMCw3NDAxNywxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzE3
| NDA4LDY3OTQ0LDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbMTc0MDgsNjc5MzcsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFs4MTky
| LDc0MDgwLDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbMTc0MDgsNjU4ODksMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFsxMjI4OCw2
| NTgyNCwxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzE2NTEyLDY1ODg4LDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbMTAyNCw2NTg1
| NywxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzgxOTIsNjU2MzIsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFswLDY1NjE2LDEzMTA3
| MiwxOTY2MDgsMjYyMTQ0XSxbOTIxNiw2NTgyNCwxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzIwNDgsNjk2MzIsMTMxMDcyLDIw
| NDgwMCwyNjIxNDRdLFsxNjM4NCw2NjY1NiwxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzMyLDY1NjE2LDEzMTA3MiwxOTY2MDgs
| MjYyMTQ0XSxbNTI0Mzg0LDY1NTM2LDEzNTE2OCwyNDI2ODgsMjYyMTQ0XSxbMjA0OCw2OTYzMiwxMzEwNzIsMjA0ODAwLDI2
| MjE0NF1dXX0=

; the code of every pixel
.pixels tile 1 1
| 0
