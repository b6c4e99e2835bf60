# Writes an OBJ file for the download: each number of a v, vt, f, l or #v line as the difference from the one
# at its place in the line of the same kind before, coordinates in hundredths; of a #v line those of the way
# since the last moment. What is left compresses to a third. src/surface/packed.rs reads it back.

BEGIN { vertices = 0 }

function whole(number) { return int(number < 0 ? number - 0.5 : number + 0.5) }

$1 == "v" || $1 == "vt" || $1 == "f" || $1 == "l" || $1 == "#v" {
    scale = $1 ~ /v/ ? 100 : 1
    line = $1
    rest = substr($0, length($1) + 1)
    for (place = 0; match(rest, /[-0-9.]+/); place++) {
        number = substr(rest, RSTART, RLENGTH) * scale
        if (number - whole(number) > 1e-6 || whole(number) - number > 1e-6) {
            print FILENAME ": more than two decimals: " $0 >"/dev/stderr"
            exit 1
        }
        number = whole(number)
        if ($1 == "#v") {
            way = number - last[vertex, place]
            last[vertex, place] = number
            number = way
        } else if ($1 == "v") {
            last[vertices, place] = number
        }
        line = line substr(rest, 1, RSTART - 1) (number - before[$1, place])
        before[$1, place] = number
        rest = substr(rest, RSTART + RLENGTH)
    }
    # Of the many lines of moments the name is left away.
    sub(/^#v/, "", line)
    print line rest
    if ($1 == "v") vertices++
    if ($1 == "#v") vertex++
    next
}
$1 == "#moment" {
    vertex = 0
    for (place = 0; place < 3; place++) before["#v", place] = 0
}
{ print }
