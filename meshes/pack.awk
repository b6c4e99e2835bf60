# Writes an OBJ file for the download. Lines of the same kind that follow each other, v, vt or #v, become one, which
# has all their first numbers, then all their second ones and so on: in hundredths, each as the difference from the
# one before it, as one or two letters. Of a #v line, whose name is left away, they are those of the way since the last moment. The
# numbers of an f or l line are the differences from those at their places in the line before. What is left compresses
# to a third. src/surface/packed.rs reads it back.

BEGIN {
    vertices = vertex = rows = 0
    # All that is seen of ASCII, but for what begins an end of a script, and what begins a number in digits.
    for (code = 33; code < 126; code++) if (code != 60) letters = letters sprintf("%c", code)
    singles = 60
    pairs = length(letters) - singles
}

function whole(number) { return int(number < 0 ? number - 0.5 : number + 0.5) }

function stop(why) {
    print FILENAME ": " why ": " $0 >"/dev/stderr"
    failed = 1
    exit 1
}

# A number as letters: first how far it is from 0 and on which side, as a whole number.
function letter(number, size) {
    size = number < 0 ? -2 * number - 1 : 2 * number
    if (size < singles) return substr(letters, size + 1, 1)
    size -= singles
    if (size < pairs * length(letters))
        return substr(letters, singles + int(size / length(letters)) + 1, 1) substr(letters, size % length(letters) + 1, 1)
    return "~" number " "
}

# Prints the lines that were kept, as one.
function flush(place, k, before, text) {
    if (!rows) return
    text = kind " "
    for (place = 0; place < places; place++) {
        before = 0
        for (k = 0; k < rows; k++) {
            text = text letter(kept[k, place] - before)
            before = kept[k, place]
        }
    }
    sub(/^#v/, "", text)
    print text
    rows = 0
}

$1 == "v" || $1 == "vt" || $1 == "#v" {
    if (kind != $1 || places != NF - 1) flush()
    kind = $1
    places = NF - 1
    if (places != (kind == "vt" ? 2 : 3)) stop("not the numbers of a vertex")
    for (place = 0; place < places; place++) {
        number = $(place + 2) * 100
        if (number - whole(number) > 1e-6 || whole(number) - number > 1e-6) stop("more than two decimals")
        number = whole(number)
        if (kind == "#v") {
            kept[rows, place] = number - last[vertex, place]
            last[vertex, place] = number
        } else {
            kept[rows, place] = number
            if (kind == "v") last[vertices, place] = number
        }
    }
    rows++
    if (kind == "v") vertices++
    if (kind == "#v") vertex++
    next
}

{ flush() }

$1 == "f" || $1 == "l" {
    line = $1
    rest = substr($0, length($1) + 1)
    for (place = 0; match(rest, /[-0-9.]+/); place++) {
        number = substr(rest, RSTART, RLENGTH)
        line = line substr(rest, 1, RSTART - 1) (number - before_it[$1, place])
        before_it[$1, place] = number
        rest = substr(rest, RSTART + RLENGTH)
    }
    print line rest
    next
}
$1 == "#moment" { vertex = 0 }
{ print }
END { if (!failed) flush() }
