; 8 slots, 4000 us of light a frame
; 15 words stored in 3 kernels; 15 executed a frame in 3 launches, 6 us
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
| where_obeys_flag = true                    # does the analog `where` itself act only where FLAG is 1? (not public)
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
| adc_bits = 2                               # bits of the readout
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
.note class "general"
.note codes "open"
.note level "0"
.note lowering "edges"

.source
| # What moves within one frame: the late half of the exposure less the early half, blurred.
| nsl 3
| frame 8 slots of 500us
| outside 0
| bucket early open when n < 4
| bucket late open when n >= 4
|
| kernel blur = [[1, 2, 1], [2, 4, 2], [1, 2, 1]] / 16
| kernel around = [[1, 1, 1], [1, 1, 1], [1, 1, 1]]
| image change = blur(late - early)
| plane moved = change > 4% or change < -4%
| plane sure = all(moved, around)
| read change, moved
| report any sure

.wait 500us x8

.kernel k0                               ; 9 words, 2.8 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    bus B, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus C, NEWS

.kernel k1                               ; 4 words, 1.8 us; launched at 4
    bus NEWS, A, PIX
    bus A, C, NEWS
    bus NEWS, B, C
    bus B, NEWS, PIX

.kernel k2                               ; 2 words, 1.4 us; launched at 8
    bus NEWS, B, PIX
    bus B, C, NEWS

.slot 0 k0
.slot 4 k1
.slot 8 k2

.bucket early late
.readout A early 1
.readout B late 1

; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0000000000000 0..3 4..7         ; 0
; a line a code: its shutter, then its fields
.code 0

; images and planes: these words follow the last slot's
; kernel 0, IN at -5
;     all
;     bus NEWS, A
;     bus C, B, NEWS
;     bus XW, C
;     bus2 A, B, C, NEWS
;     bus2 NEWS, D, A, C
;     bus C, D, XW
;     bus XN, C
;     bus2 E, F, C, NEWS
;     bus2 NEWS, F, C, E
;     bus E, F, XN
;     bus F, E
;     where F, IN
;     MOV R5, FLAG
;     all
; kernel 1, IN at 5
;     where F, IN
;     MOV R6, FLAG
;     all
;     NOT R7, R6
;     OR R6, R5, R7
;     NOT R5, R6
;     CLR R1, R2, R3, R4
;     SET R2, R4
;     DNEWS1 R7, R5
;     OR R8, R5, R7
;     CLR R1, R2, R3, R4
;     SET R1, R3
;     DNEWS1 R7, R8
;     OR R9, R7, R8
;     NOT R5, R9
; F holds change
; R6 holds moved
; R5 holds sure
.pictures
| eyJjb3N0cyI6W1siY2hhbmdlIiwxMSwxLjAsMi41MDMxMjMwNDkzMTI1OThdLFsibW92ZWQiLDgsMC4wLDAuMF0sWyJzdXJl
| IiwxMCwwLjAsMC4wXV0sIml0ZW1zIjpbWyJjaGFuZ2UiLFsiRmlsdGVyZWQiLCJibHVyIixbIlN1bSIsWzEsMSxbIlNvdXJj
| ZSIsImxhdGUiXV0sWy0xLDEsWyJTb3VyY2UiLCJlYXJseSJdXV1dXSxbIm1vdmVkIixbIkpvaW5lZCIsIm9yIixbIkFib3Zl
| IixbIlNvdXJjZSIsImNoYW5nZSJdLDVdLFsiSW52ZXJzZSIsWyJBYm92ZSIsWyJTb3VyY2UiLCJjaGFuZ2UiXSwtNV1dXV0s
| WyJzdXJlIixbIk5lYXIiLCJhbGwiLFsiQml0IiwibW92ZWQiXSwiYXJvdW5kIl1dXSwia2VybmVscyI6W1siYmx1ciIsW1sx
| LDIsMV0sWzIsNCwyXSxbMSwyLDFdXSwxNl0sWyJhcm91bmQiLFtbMSwxLDFdLFsxLDEsMV0sWzEsMSwxXV0sMV1dLCJsYXVu
| Y2hlcyI6W1swLC01XSxbMSw1XV0sImxpbWl0c19lIjp7ImVhcmx5IjozMDAwMC4wLCJsYXRlIjozMDAwMC4wfSwib3V0c2lk
| ZSI6MCwicmVhZHMiOlsiY2hhbmdlIiwibW92ZWQiXSwicmVnaXN0ZXJzIjp7ImNoYW5nZSI6IkYiLCJtb3ZlZCI6IlI2Iiwi
| c3VyZSI6IlI1In0sInJlcG9ydHMiOltbImFueSIsInN1cmUiLDBdXSwid29yZHMiOltbWzIwNDgsNjk2MzIsMTMxMDcyLDIw
| NDgwMCwyNjIxNDRdLFsxMDI0LDY1ODI1LDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbMzM3OTIsNjU5ODQsMTMxMDcyLDE5NjYw
| OCwyNjIxNDRdLFswLDc0MTEzLDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbMjU2MDAsNjYwMTYsMTMxMDcyLDE5NjYwOCwyNjIx
| NDRdLFsxMDI0LDY2NDY3LDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbMzI3NjgsNzQ2MjQsMTMxMDcyLDE5NjYwOCwyNjIxNDRd
| LFsxMjgsNjU5MjEsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFsxMDI0LDY5MDA0LDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbMTAy
| NCw2OTAwMSwxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzEyOCw2ODg2OCwxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzAsNjg2MTYs
| MTMxMDcyLDE5NjYwOCwyNjIxNDRdLFszMiw2NzYwMCwxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzUyNDM4NCw2NTUzNiwxMzEw
| NzIsMjUzOTUzLDI2MjE0NF0sWzIwNDgsNjk2MzIsMTMxMDcyLDIwNDgwMCwyNjIxNDRdXSxbWzMyLDY3NjAwLDEzMTA3Miwx
| OTY2MDgsMjYyMTQ0XSxbNTI0Mzg0LDY1NTM2LDEzMTA3MiwyNTM5NTQsMjYyMTQ0XSxbMjA0OCw2OTYzMiwxMzEwNzIsMjA0
| ODAwLDI2MjE0NF0sWzUyNDMyMCw2NTUzNiwxMzExMDQsMjQyNjkyLDI2MjE0NF0sWzUyNDMyMCw2NTUzNiwxMzExNTIsMjUz
| OTU0LDI2MjE0NF0sWzUyNDMyMCw2NTUzNiwxMzExMDQsMjQyNjg5LDI2MjE0NF0sWzUyNDMyMCw2NTUzNiwxOTI1MTIsMjUz
| OTUyLDI2MjE0NF0sWzUyNDMyMCw2NTUzNiwxNzIwMzIsMjAwNzA0LDI2MjE0NF0sWzEwNTA2NTYsMTE0Njg4LDEzMTA4OCwy
| MjMyMzYsMjYyMTQ0XSxbNTI0MzIwLDY1NTM2LDEzMTE1MiwyNTM5NjAsMjYyMTQ0XSxbNTI0MzIwLDY1NTM2LDE5MjUxMiwy
| NTM5NTIsMjYyMTQ0XSxbNTI0MzIwLDY1NTM2LDE1MTU1MiwyMDA3MDQsMjYyMTQ0XSxbMTA1MDY1NiwxMTQ2ODgsMTMxMjAw
| LDIyMzIzNiwyNjIxNDRdLFs1MjQzMjAsNjU1MzYsMTMxMjY0LDI1Mzk2OCwyNjIxNDRdLFs1MjQzMjAsNjU1MzYsMTMxMzI4
| LDI0MjY4OSwyNjIxNDRdXV19

; the code of every pixel
.pixels tile 1 1
| 0
