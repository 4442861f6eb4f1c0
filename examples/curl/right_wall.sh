#!/usr/bin/env bash
# Follow the right-hand wall through a maze, with curl.
#
# Run it with the robot's address, as the page shows it under Remote (keep the quotes; where it cannot
# be copied, a code gets one: see the README of the examples):
#
#     bash right_wall.sh "http://localhost:8080/r/ID#KEY"
#
# The robot keeps its right hand on the wall: where there is an opening on the right it goes in, else
# straight on, else it turns left.
set -uo pipefail

CELL=100      # one cell of the maze is 100 cm wide
OPEN=60       # farther than this, and there is no wall in the next cell
PATIENCE=30   # seconds that the service may stay silent
NAME="Right wall"   # what the robot's owner sees of this program

address=${1-} until_cells=0 most_moves=2000
shift || true
while [ $# -ge 2 ]; do
  case $1 in
    --until-cells) until_cells=$2 ;;
    --moves) most_moves=$2 ;;
  esac
  shift 2
done

fail() {
  echo "$1" >&2
  exit 1
}

pattern='^(https?://[^/?#[:space:]@]+)/r/([A-Za-z0-9_-]+)#([A-Za-z0-9_-]{8,64})$'
if ! [[ $address =~ $pattern ]]; then
  fail "This is not a robot's address. Copy the whole address from the page, and put it in \"quotes\": the part after the # is the key."
fi
api="${BASH_REMATCH[1]}/api/v1/robots/${BASH_REMATCH[2]}"
key=${BASH_REMATCH[3]}

# One field of a JSON text, in which each of the names that are asked for comes once.
field() { sed -nE "s/.*\"$2\": *\"?([^,\"}]*).*/\1/p" <<<"$1"; }

# The sentence in which the service says what is wrong.
sentence() { sed -nE 's/.*"detail": *"(([^"\\]|\\.)*)".*/\1/p' <<<"$1" | sed 's/\\"/"/g'; }

# One request: ask METHOD PATH [FIELDS]. Tries again when the network or the service has a bad moment.
# The answer is in $answer.
ask() {
  local method=$1 path=$2 fields=${3-} began=$SECONDS tries=0 status age more
  # The key makes a retry safe: a command that arrives twice is done once.
  local once="curl-$$-$RANDOM$RANDOM$RANDOM"
  while true; do
    more=()
    if [ -n "$fields" ]; then
      # How old the wish is, rounded up: one that comes late is not done late.
      age=$(((SECONDS - began + 1) * 1000))
      [ "$tries" -gt 0 ] && age=",\"age\":$age" || age=""
      more=(-H "Content-Type: application/json" -H "Idempotency-Key: $once" -d "{$fields$age}")
    fi
    # The key comes by standard input: other users of this machine can read a command line.
    if answer=$(curl --silent --show-error --max-time 20 --request "$method" --config - \
      --header "Script-Name: $NAME" --write-out '\n%{http_code}' "${more[@]}" "$api$path" \
      2>&1 <<<"header = \"Authorization: Bearer $key\""); then
      status=${answer##*$'\n'}
    else
      # No answer, or one that was cut, which has a status all the same.
      status=000
    fi
    answer=${answer%$'\n'*}
    case $status in
      2??) return ;;
      000 | 429 | 5??) ;;
      *) fail "$(sentence "$answer" | grep . || echo "The service answered with status $status.")" ;;
    esac
    tries=$((tries + 1))
    [ $((SECONDS - began)) -lt $PATIENCE ] || fail "The service does not answer: $answer"
    # Drawn by lot, so that a whole class does not come back in the same moment.
    sleep "$(awk -v n=$tries -v seed=$RANDOM 'BEGIN { srand(seed); p = 0.125 * 2 ^ n; print rand() * (p < 10 ? p : 10) }')"
  done
}

# Sends a command, waits until it has ended; how is in $state.
command() {
  ask POST /commands "$1"
  while true; do
    state=$(field "$answer" state)
    case $state in
      completed | collided) return ;;
      accepted | delivered | started) ask GET "/commands/$(field "$answer" seq)?wait=10" ;;
      *) fail "The command was $state: $(field "$answer" reason)" ;;
    esac
  done
}

visited=" " cells=0 moves=0
while true; do
  ask GET "/sensors?wait=10"
  right=$(field "$answer" right) front=$(field "$answer" front)
  right=${right%.*} front=${front%.*}
  x=$(field "$answer" x) y=$(field "$answer" y)
  [ -n "$right" ] && [ -n "$x" ] || fail "What answers at this address is not a robot's host."
  cell="$((${x%.*} / CELL)),$((${y%.*} / CELL))"
  if [[ $visited != *" $cell "* ]]; then
    visited+="$cell "
    cells=$((cells + 1))
  fi
  if [ "$until_cells" -eq 0 ] && [ "$(field "$answer" goalReached)" = true ]; then
    echo "Goal reached after $moves moves."
    exit 0
  fi
  if [ "$until_cells" -gt 0 ] && [ "$cells" -ge "$until_cells" ]; then
    echo "$cells cells visited after $moves moves."
    exit 0
  fi
  [ "$moves" -lt "$most_moves" ] || fail "Not there after $moves moves; $cells cells visited."

  if [ "$right" -gt $OPEN ]; then
    echo "$right cm on the right: turn right and go"
    command '"action":"right 90"'
    command "\"action\":\"move\",\"distance\":$CELL"
    moves=$((moves + 1))
  elif [ "$front" -gt $OPEN ]; then
    echo "$front cm ahead: go on"
    command "\"action\":\"move\",\"distance\":$CELL"
    moves=$((moves + 1))
  else
    echo "Wall ahead and on the right: turn left"
    command '"action":"left 90"'
  fi
  [ "$state" = completed ] || echo "Bumped into a wall!"
done
