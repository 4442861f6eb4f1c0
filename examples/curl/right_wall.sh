#!/usr/bin/env bash
# Follow the right-hand wall through a maze, with curl.
#
# Run it with the robot's address, which the page shows under Remote. Keep the quotes. If you cannot
# copy the address, use a pairing code: see the README of the examples.
#
#     bash right_wall.sh "http://localhost:8080/r/ID#KEY"
#
# The robot follows the wall on its right: it turns right at an opening, else drives straight ahead,
# else turns left.
set -uo pipefail

CELL=100      # one cell of the maze is 100 cm wide
OPEN=60       # a larger distance means that the next cell is open
TIMEOUT=30    # seconds without an answer after which the program gives up
NAME="Right wall"   # the name of this program on the robot's page

address=${1-} until_cells=0 max_moves=2000
shift || true
while [ $# -ge 2 ]; do
  case $1 in
    --until-cells) until_cells=$2 ;;
    --moves) max_moves=$2 ;;
  esac
  shift 2
done

fail() {
  echo "$1" >&2
  exit 1
}

pattern='^(https?://[^/?#[:space:]@]+)/r/([A-Za-z0-9_-]{1,64})#([A-Za-z0-9_-]{8,64})$'
if ! [[ $address =~ $pattern ]]; then
  fail "This is not a robot's address. Copy the whole address from the page, and put it in \"quotes\": the part after the # is the key."
fi
api="${BASH_REMATCH[1]}/api/v1/robots/${BASH_REMATCH[2]}"
key=${BASH_REMATCH[3]}

# Prints one field of a JSON text. Each requested name appears only once in the text.
field() { sed -nE "s/.*\"$2\": *\"?([^,\"}]*).*/\1/p" <<<"$1"; }

# Prints the error message of the service.
error_message() { sed -nE 's/.*"detail": *"(([^"\\]|\\.)*)".*/\1/p' <<<"$1" | sed 's/\\"/"/g'; }

# Sends a request: request METHOD PATH [FIELDS]. Retries after network errors and server errors.
# The response is in $answer.
request() {
  local method=$1 path=$2 fields=${3-} started=$SECONDS tries=0 status age more
  # The key makes a retry safe: a command that arrives twice runs once.
  local idempotency_key="curl-$$-$RANDOM$RANDOM$RANDOM"
  while true; do
    more=()
    if [ -n "$fields" ]; then
      # With the age in ms, rounded up, the robot rejects a retry that arrives too late.
      age=$(((SECONDS - started + 1) * 1000))
      [ "$tries" -gt 0 ] && age=",\"age\":$age" || age=""
      more=(-H "Content-Type: application/json" -H "Idempotency-Key: $idempotency_key" -d "{$fields$age}")
    fi
    # The key is passed by standard input, because other users of this machine can read arguments.
    if answer=$(curl --silent --show-error --max-time 20 --request "$method" --config - \
      --header "Script-Name: $NAME" --write-out '\n%{http_code}' "${more[@]}" "$api$path" \
      2>&1 <<<"header = \"Authorization: Bearer $key\""); then
      status=${answer##*$'\n'}
    else
      # No response, or an incomplete response, which may have a status.
      status=000
    fi
    answer=${answer%$'\n'*}
    case $status in
      2??) return ;;
      000 | 429 | 5??) ;;
      *) fail "$(error_message "$answer" | grep . || echo "The service answered with status $status.")" ;;
    esac
    tries=$((tries + 1))
    [ $((SECONDS - started)) -lt $TIMEOUT ] || fail "The service does not respond: $answer"
    # A random delay, so that the programs of a whole class do not retry at the same moment.
    sleep "$(awk -v n=$tries -v seed=$RANDOM 'BEGIN { srand(seed); p = 0.125 * 2 ^ n; print rand() * (p < 10 ? p : 10) }')"
  done
}

# Sends a command and waits until it has ended. Its state is in $state.
send_command() {
  request POST /commands "$1"
  while true; do
    state=$(field "$answer" state)
    case $state in
      completed | collided) return ;;
      accepted | delivered | started) request GET "/commands/$(field "$answer" seq)?wait=10" ;;
      *) fail "The command was $state: $(field "$answer" reason)" ;;
    esac
  done
}

visited=" " cells=0 moves=0
while true; do
  request GET "/sensors?wait=10"
  right=$(field "$answer" right) front=$(field "$answer" front)
  right=${right%.*} front=${front%.*}
  x=$(field "$answer" x) y=$(field "$answer" y)
  [ -n "$right" ] && [ -n "$x" ] || fail "The server at this address is not a robot's host."
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
  [ "$moves" -lt "$max_moves" ] || fail "Goal not reached after $moves moves; $cells cells visited."

  if [ "$right" -gt $OPEN ]; then
    echo "$right cm on the right: turn right and drive"
    send_command '"action":"right 90"'
    send_command "\"action\":\"move\",\"distance\":$CELL"
    moves=$((moves + 1))
  elif [ "$front" -gt $OPEN ]; then
    echo "$front cm ahead: drive on"
    send_command "\"action\":\"move\",\"distance\":$CELL"
    moves=$((moves + 1))
  else
    echo "Wall ahead and on the right: turn left"
    send_command '"action":"left 90"'
  fi
  [ "$state" = completed ] || echo "Bumped into a wall!"
done
