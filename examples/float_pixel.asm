; 256 slots, 32000 us of light a frame
; 61 words stored in 10 kernels; 61 executed a frame in 10 launches, 20.2 us
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
| readout = "half"                           # codes of 0 .. full_well_e: spread, all of them (2 x exposure - full well is converted); full, the upper half, for the converter is symmetric around 0; half, 0 to the middle (not public)
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
.note class "looking"
.note codes "open"
.note level "0"
.note lowering "latch"

.source
| # A pixel that floats: it closes at the first look at which it is brighter than 45 % of a full well,
| # and says when. The exposure divided by the time that the pixel was open is the light, over eight
| # doublings of exposure time, from one frame and without a decoder.
| nsl 2
|
| frame 256 slots of 125us            # 32 ms in all
|
| sense bright when light > 45% at n in [1, 2, 4, 8, 16, 32, 64, 128]
|
| state closed_at : 0..8 = 0          # 0: open to the end
| next closed_at = looks when bright and closed_at == 0
|
| open when closed_at == 0
| read closed_at

.wait 125us x256

.kernel k0                               ; 9 words, 2.6 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    rpix
    rpix
    nop
    bus B, PIX
    CLR R1, R2, R3, R4
    CLR R5, R6, R7, R8

.kernel k1                               ; 6 words, 2 us; launched at 1
    all
    bus NEWS, B, PIX
    where NEWS, IN
    NOT R1, FLAG
    WHERE R1
    bus A, NEWS

.kernel k2                               ; 6 words, 2 us; launched at 2
    all
    bus NEWS, B, PIX
    where NEWS, IN
    NOR R2, R1, FLAG
    WHERE R2
    bus A, NEWS

.kernel k3                               ; 6 words, 2 us; launched at 4
    all
    bus NEWS, B, PIX
    where NEWS, IN
    NOR R3, R1, R2, FLAG
    WHERE R3
    bus A, NEWS

.kernel k4                               ; 6 words, 2 us; launched at 8
    all
    bus NEWS, B, PIX
    where NEWS, IN
    NOR R4, R1, R2, R3, FLAG
    WHERE R4
    bus A, NEWS

.kernel k5                               ; 6 words, 2 us; launched at 16
    all
    bus NEWS, B, PIX
    where NEWS, IN
    NOR R5, R1, R2, R3, R4, FLAG
    WHERE R5
    bus A, NEWS

.kernel k6                               ; 6 words, 2 us; launched at 32
    all
    bus NEWS, B, PIX
    where NEWS, IN
    NOR R6, R1, R2, R3, R4, R5, FLAG
    WHERE R6
    bus A, NEWS

.kernel k7                               ; 6 words, 2 us; launched at 64
    all
    bus NEWS, B, PIX
    where NEWS, IN
    NOR R7, R1, R2, R3, R4, R5, R6, FLAG
    WHERE R7
    bus A, NEWS

.kernel k8                               ; 6 words, 2 us; launched at 128
    all
    bus NEWS, B, PIX
    where NEWS, IN
    NOR R8, R1, R2, R3, R4, R5, R6, R7, FLAG
    WHERE R8
    bus A, NEWS

.kernel k9                               ; 4 words, 1.6 us; launched at 256
    NOR R0, R1, R2, R3, R4, R5, R6, R7, R8
    WHERE R0
    bus NEWS, B, PIX
    bus A, NEWS

.slot 0 k0
.slot 1 k1
.slot 2 k2
.slot 4 k3
.slot 8 k4
.slot 16 k5
.slot 32 k6
.slot 64 k7
.slot 128 k8
.slot 256 k9

.bucket frame
.readout A frame 1

; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0000000000000 0..255            ; 0
; a line a code: its shutter, then its fields
.code 0

; at boundary 1: light above 57 steps of IN, 13464.6 e
; at boundary 2: light above 57 steps of IN, 13464.6 e
; at boundary 4: light above 57 steps of IN, 13464.6 e
; at boundary 8: light above 57 steps of IN, 13464.6 e
; at boundary 16: light above 57 steps of IN, 13464.6 e
; at boundary 32: light above 57 steps of IN, 13464.6 e
; at boundary 64: light above 57 steps of IN, 13464.6 e
; at boundary 128: light above 57 steps of IN, 13464.6 e
.machine
| FAIAAHsiY29tcGFyaXNvbnMiOltbMSwtMSw1N10sWzIsLTEsNTddLFs0LC0xLDU3XSxbOCwtMSw1N10sWzE2LC0xLDU3XSxb
| MzIsLTEsNTddLFs2NCwtMSw1N10sWzEyOCwtMSw1N11dLCJmaXJzdCI6WzAsMSwzLDYsMTAsMTUsMjEsMjgsMzYsNDVdLCJs
| ZXZlbHMiOltudWxsLDU3LDU3LDU3LDU3LDU3LDU3LDU3LDU3LG51bGxdLCJsb29rcyI6WzEsMiw0LDgsMTYsMzIsNjQsMTI4
| XSwib3V0Y29tZXMiOjIsInBsYW5lcyI6W1siY2xvc2VkX2F0IixbIlIxIiwiUjIiLCJSMyIsIlI0IiwiUjUiLCJSNiIsIlI3
| IiwiUjgiXSxbMCwxLDIsMyw0LDUsNiw3LDhdLFtbMCwwLDAsMCwwLDAsMCwwXSxbMSwwLDAsMCwwLDAsMCwwXSxbMCwxLDAs
| MCwwLDAsMCwwXSxbMCwwLDEsMCwwLDAsMCwwXSxbMCwwLDAsMSwwLDAsMCwwXSxbMCwwLDAsMCwxLDAsMCwwXSxbMCwwLDAs
| MCwwLDEsMCwwXSxbMCwwLDAsMCwwLDAsMSwwXSxbMCwwLDAsMCwwLDAsMCwxXV1dXSwic3RhdGVzIjpbWyJjbG9zZWRfYXQi
| LDAsOCwwLGZhbHNlLHRydWUsZmFsc2UsZmFsc2VdXX0AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAQAAAAAAAAAAAAAAAAAAAAEAAAAAAAAAAgAAAAAAAAAAAAAAAAAAAAEAAAAAAAAAAgAAAAAAAAADAAAA
| AAAAAAAAAAAAAAAAAQAAAAAAAAACAAAAAAAAAAMAAAAAAAAABAAAAAAAAAAAAAAAAAAAAAEAAAAAAAAAAgAAAAAAAAADAAAA
| AAAAAAQAAAAAAAAABQAAAAAAAAAAAAAAAAAAAAEAAAAAAAAAAgAAAAAAAAADAAAAAAAAAAQAAAAAAAAABQAAAAAAAAAGAAAA
| AAAAAAAAAAAAAAAAAQAAAAAAAAACAAAAAAAAAAMAAAAAAAAABAAAAAAAAAAFAAAAAAAAAAYAAAAAAAAABwAAAAAAAAAAAAAA
| AAAAAAEAAAAAAAAAAgAAAAAAAAADAAAAAAAAAAQAAAAAAAAABQAAAAAAAAAGAAAAAAAAAAcAAAAAAAAACAAAAAAAAAABAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAIAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAMAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAADwAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAD/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAP//AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA/////wAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA//////////8AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAA/////////////////////wAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA
| AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAABAAAA
| AgAAAAMAAAAFAAAABAAAAAQAAAAGAAAACQAAAAcAAAAHAAAACAAAAAgAAAAKAAAADgAAAAsAAAALAAAADAAAAAwAAAANAAAA
| DQAAAA8AAAAUAAAAEAAAABAAAAARAAAAEQAAABIAAAASAAAAEwAAABMAAAAVAAAAGwAAABYAAAAWAAAAFwAAABcAAAAYAAAA
| GAAAABkAAAAZAAAAGgAAABoAAAAcAAAAIwAAAB0AAAAdAAAAHgAAAB4AAAAfAAAAHwAAACAAAAAgAAAAIQAAACEAAAAiAAAA
| IgAAACQAAAAsAAAAJQAAACUAAAAmAAAAJgAAACcAAAAnAAAAKAAAACgAAAApAAAAKQAAACoAAAAqAAAAKwAAACsAAAD/////
| ////////////////////////////////////////////////////////////////////////////////////////////////
| ////////////////////////////////////////////////////////////////////////////////////////////////
| //////////////////////////////////////////////////////////////////////////////////////////8AAQAA
| AQAAAAIAAAAEAAAACAAAABAAAAAgAAAAQAAAAIAAAAAAAAAAAADwvwAAAAAAAPC/AAAAAAAA8L8AAAAAAADwvwAAAAAAAPC/
| AAAAAAAA8L8AAAAAAADwvwAAAAAAAPC/AAAAAAAA8L8AAAAAAADwvwAAAAAAAPC/AAAAAAAA8L8AAAAAAADwvwAAAAAAAPC/
| AAAAAAAA8L8AAAAAAADwvwAAAAAAAPC/AAAAAAAA8L8AAAAAAADwvwAAAAAAAPC/AAAAAAAA8L8AAAAAAADwvwAAAAAAAPC/
| AAAAAAAA8L8AAAAAAADwvwAAAAAAAPC/AAAAAAAA8L8AAAAAAADwvwAAAAAAAPC/AAAAAAAA8L8AAAAAAADwvwAAAAAAAPC/
| AAAAAAAA8L8AAAAAAADwvwAAAAAAAPC/AAAAAAAA8L8AAAAAAEDfQAAAAAAAQF9AAAAAAABAb0AAAAAAAEB/QAAAAAAAQI9A
| AAAAAABAn0AAAAAAAECvQAAAAAAAQL9AAAAAAABAz0A=

; the code of every pixel
.pixels tile 1 1
| 0
