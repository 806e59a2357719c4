# What all pictures share; each script loads this first. It reads the arguments, opens the picture, and writes the title.
# The script sets width and height in pixels before.
# SPDX-License-Identifier: GPL-3.0-or-later
if (!strlen(given[2])) { print 'usage: gnuplot -c SCRIPT TABLE PICTURE [TITLE [WIDTHxHEIGHT [FROM:TO]]]'; exit status 1 }
table = given[1]; picture = given[2]; title = given[3]; size = given[4]; range = given[5]
load here.'look.gp'
if (GPVAL_VERSION >= 6) { unset warnings } # of columns without a value, as CoR_T is at normal impact
if (strlen(size)) { width = int(size[1:strstrt(size, 'x') - 1]); height = int(size[strstrt(size, 'x') + 1:*]) }
ending = picture[strlen(picture) - 2:*]
if (ending eq 'svg') { set term svg enhanced size width,height font 'sans,14' background 'white' }
if (ending eq 'pdf') { set term pdfcairo enhanced size width / 96.,height / 96. font 'sans,11' }
if (ending eq 'png') { set term pngcairo enhanced size width,height font 'sans,11' }
if (picture[1:1] ne '-') { set output picture } # else to standard output, as -.png
set datafile separator ','
set datafile missing NaN # a line goes on over rows of others
# The title in lines that fit; `top` is the upper edge of the panels, below the title, the legend and a caption.
head = ''; line = ''; lines = 0; word = ''
do for [i=1:strlen(title) + 1] {
  if (i > strlen(title) || title[i:i] eq ' ') {
    if (strlen(line) && strlen(line.word) > width / 8) { head = head.line."\n"; line = ''; lines = lines + 1 }
    line = line.(strlen(line) ? ' ' : '').word; word = ''
  } else { word = word.title[i:i] }
}
head = head.line
if (strlen(line)) { lines = lines + 1 }
legend = 1 - (20. * lines + 8) / height
top = legend - 62. / height
left = 95. / width; right = 1 - 25. / width; bottom = 60. / height
set key noenhanced at screen 0.5,screen legend center top horizontal maxrows 2
set tmargin at screen top; set bmargin at screen bottom; set lmargin at screen left; set rmargin at screen right
set multiplot title head noenhanced
# The vertical axis: as the user wants it, or from and to.
axis(from, to) = strlen(range) ? range : sprintf('%.10g:%.10g', from, to)
low(r) = real(r[1:strstrt(r, ':') - 1]); high(r) = real(r[strstrt(r, ':') + 1:*])
min(a, b) = a < b ? a : b
max(a, b) = a > b ? a : b
is(v) = v == v
# Histograms: the middle of a bin, and what a row adds to it. Rows without a value must be somewhere, too.
middle(v, wide) = is(v) ? (floor(v / wide) + 0.5) * wide : 0
part(v, share) = is(v) ? share : 0
# The axis of CoR_N (t = 0) or CoR_T: 0 to 1, and of what lies beyond at most 0 to 3, or -1 to 2.
coefficient(t, from, to) = t ? axis(max(-1, min(0, from)), min(2, max(1, to))) : axis(0, min(3, max(1, to)))
cor(t) = t ? 'CoR_T' : 'CoR_N'
outside(n, of) = n ? sprintf('outside: %d of %d', n, of) : ''
# One of two panels, left (t = 0) and right.
drawn = 0
panel = 'drawn = drawn + 1; set lmargin at screen left + 0.5 * t; set rmargin at screen right - 0.5 * (1 - t)'
set_y = "if (strlen(range)) { set yrange [low(range):high(range)] } else { set yrange [0:*] }"
# The number and the ends of the values of a column: @survey; stats table using (take(VALUE)) nooutput. stats leaves out
# what the axes do.
survey = 'set xrange [*:*]; set yrange [*:*]; seen = 0; least = NaN; most = NaN'
take(v) = is(v) ? (seen = seen + 1, least = seen > 1 ? min(least, v) : v, most = seen > 1 ? max(most, v) : v, 1) : 1
# Sets the vertical axis of a coefficient from them, and counts the values beyond it: stats ... using (check(VALUE)).
set_axis = "r = coefficient(t, least, most); y = low(r); y_to = high(r); set yrange [y:y_to]; set ylabel cor(t); beyond = 0"
check(v) = (beyond = beyond + (v < y || v > y_to), 1)
check_bar(from, to) = (beyond = beyond + (from < y || to > y_to), 1)
set_label = "set label 1 outside(beyond, seen) at graph 1,1 right offset 0,0.7 font ',9'"
# How many of the impacts stick: above the first panel, or alone in the picture, where there is nothing else to draw.
stuck = 0
text_of_stuck(n) = sprintf('%.0f of %.0f impacts stick', stuck, n)
set_stuck = "set label 2 text_of_stuck(hits) at graph 0,1 left offset 0,0.7 font ',9'"
set_all_stuck = "if (drawn == 0) { set label 2 text_of_stuck(hits) at screen 0.5,0.5 center; unset border; unset tics; ".\
  "unset xlabel; unset ylabel; set xrange [0:1]; set yrange [0:1]; plot -1 notitle }"
# Names, each once, of a list of words.
add(list, w) = strstrt(' '.list, ' '.w.' ') ? list : list.w.' '
