// Follow the right-hand wall through a maze.
//
// Run it with the robot's address, which the page shows under Remote. Keep the quotes. If you cannot
// copy the address, use a pairing code: see the README of the examples.
//
//	go run robot.go "http://localhost:8080/r/ID#KEY"
//
// Requires Go 1.19 or newer and no packages. The robot follows the wall on its right: it turns right at
// an opening, else drives straight ahead, else turns left.
package main

import (
	"bytes"
	crand "crypto/rand"
	"encoding/hex"
	"encoding/json"
	"errors"
	"flag"
	"fmt"
	"io"
	"math"
	"math/rand"
	"net/http"
	"os"
	"regexp"
	"strings"
	"time"
)

const (
	cell = 100          // one cell of the maze is 100 cm wide
	open = 60           // a larger distance means that the next cell is open
	name = "Right wall" // the name of this program on the robot's page

	timeout    = 30 * time.Second // time without an answer after which the program gives up
	firstDelay = 250 * time.Millisecond
	maxDelay   = 10 * time.Second
)

var address = regexp.MustCompile(`^(https?://[^/?#\s@]+)/r/([A-Za-z0-9_-]{1,64})#([A-Za-z0-9_-]{8,64})$`)

// Robot is a robot on the network. Every method waits until the robot has finished.
type Robot struct {
	api, key string
	http     http.Client
}

// Snapshot contains the sensor readings and the pose of the robot in cm.
type Snapshot struct {
	Sensors     struct{ Front, Right, Back, Left float64 }
	Pose        struct{ X, Y, Heading float64 }
	GoalReached bool
}

type record struct {
	Seq           int
	Action, State string
	Reason        string
}

type problem struct {
	Detail string
	Errors []struct{ Path, Found, Expected string }
}

type command map[string]any

// NewRobot returns the robot at an address.
func NewRobot(text string) (*Robot, error) {
	parts := address.FindStringSubmatch(strings.TrimSpace(text))
	if parts == nil {
		return nil, errors.New(`This is not a robot's address. Copy the whole address from the page, and put it in "quotes": the part after the # is the key.`)
	}
	robot := &Robot{api: parts[1] + "/api/v1/robots/" + parts[2], key: parts[3]}
	robot.http.Timeout = 20 * time.Second
	// No redirects, so that the key is not sent to another host.
	robot.http.CheckRedirect = func(*http.Request, []*http.Request) error { return http.ErrUseLastResponse }
	return robot, nil
}

// Forward drives a distance in cm. It returns "completed", or "collided" if a wall stopped the robot.
func (robot *Robot) Forward(distance float64) (string, error) {
	return robot.do(command{"action": "move", "distance": distance})
}

// Left turns by 90 degrees on the spot.
func (robot *Robot) Left() (string, error) { return robot.do(command{"action": "left 90"}) }

// Right turns by 90 degrees on the spot.
func (robot *Robot) Right() (string, error) { return robot.do(command{"action": "right 90"}) }

// Snapshot returns the current snapshot, never older than the end of the last command.
func (robot *Robot) Snapshot() (Snapshot, error) {
	var snapshot Snapshot
	err := robot.request("GET", "/sensors?wait=10", nil, &snapshot)
	return snapshot, err
}

// do sends a command, waits until it has ended, and returns its state.
func (robot *Robot) do(fields command) (string, error) {
	var current record
	if err := robot.request("POST", "/commands", fields, &current); err != nil {
		return "", err
	}
	for {
		switch current.State {
		case "completed", "collided":
			return current.State, nil
		case "cancelled", "superseded", "expired":
			return "", fmt.Errorf("%s was %s: %s", current.Action, current.State, current.Reason)
		}
		path := fmt.Sprintf("/commands/%d?wait=10", current.Seq)
		if err := robot.request("GET", path, nil, &current); err != nil {
			return "", err
		}
	}
}

// request sends a request to the service. It retries after network errors and server errors.
func (robot *Robot) request(method, path string, fields command, result any) error {
	// The key makes a retry safe: a command that arrives twice runs once.
	key := make([]byte, 16)
	if _, err := crand.Read(key); err != nil {
		return err
	}
	started := time.Now()
	for attempt := 0; ; attempt++ {
		isRetryable, err := robot.send(method, path, fields, hex.EncodeToString(key), time.Since(started), result)
		if err == nil || !isRetryable {
			return err
		}
		// A random delay, so that the programs of a whole class do not retry at the same moment.
		limit := math.Min(float64(maxDelay), float64(firstDelay)*math.Pow(2, float64(attempt)))
		delay := time.Duration(rand.Float64() * limit)
		if time.Since(started)+delay > timeout {
			return err
		}
		time.Sleep(delay)
	}
}

// send sends one request. It returns whether an error is worth a retry.
func (robot *Robot) send(method, path string, fields command, key string, age time.Duration, result any) (bool, error) {
	body := []byte(nil)
	if fields != nil {
		// With the age in ms, the robot rejects a retry that arrives too late.
		if age >= time.Millisecond {
			fields["age"] = age.Milliseconds()
		}
		body, _ = json.Marshal(fields)
	}
	request, err := http.NewRequest(method, robot.api+path, bytes.NewReader(body))
	if err != nil {
		return false, err
	}
	request.Header.Set("Authorization", "Bearer "+robot.key)
	request.Header.Set("Script-Name", name)
	if fields != nil {
		request.Header.Set("Content-Type", "application/json")
		request.Header.Set("Idempotency-Key", key)
	}
	response, err := robot.http.Do(request)
	if err != nil {
		return true, fmt.Errorf("The service does not respond: %w", err)
	}
	defer response.Body.Close()
	text, err := io.ReadAll(io.LimitReader(response.Body, 1<<20))
	if err != nil {
		return true, fmt.Errorf("The service does not respond: %w", err)
	}
	if response.StatusCode/100 == 2 {
		if json.Unmarshal(text, result) != nil {
			return false, errors.New("The server at this address is not a robot's host.")
		}
		return false, nil
	}
	return response.StatusCode == 429 || response.StatusCode >= 500, errorMessage(response.StatusCode, text)
}

// errorMessage returns the error message of the service.
func errorMessage(status int, text []byte) error {
	var parsed problem
	if json.Unmarshal(text, &parsed) != nil || parsed.Detail == "" {
		return fmt.Errorf("The service answered with status %d.", status)
	}
	message := parsed.Detail
	for _, field := range parsed.Errors {
		message += fmt.Sprintf(" %s: found %s, expected %s.", field.Path, field.Found, field.Expected)
	}
	return errors.New(message)
}

// followRightWall drives until the goal is reached, or until untilCells different cells are visited.
func followRightWall(robot *Robot, untilCells, maxMoves int) error {
	visited := map[[2]int]bool{}
	for moves := 0; ; {
		snapshot, err := robot.Snapshot()
		if err != nil {
			return err
		}
		visited[[2]int{int(snapshot.Pose.X / cell), int(snapshot.Pose.Y / cell)}] = true
		if untilCells == 0 && snapshot.GoalReached {
			fmt.Printf("Goal reached after %d moves.\n", moves)
			return nil
		}
		if untilCells > 0 && len(visited) >= untilCells {
			fmt.Printf("%d cells visited after %d moves.\n", len(visited), moves)
			return nil
		}
		if moves >= maxMoves {
			return fmt.Errorf("Goal not reached after %d moves; %d cells visited.", moves, len(visited))
		}
		var state string
		if snapshot.Sensors.Right > open {
			fmt.Printf("%.0f cm on the right: turn right and drive\n", snapshot.Sensors.Right)
			if _, err = robot.Right(); err == nil {
				state, err = robot.Forward(cell)
			}
			moves++
		} else if snapshot.Sensors.Front > open {
			fmt.Printf("%.0f cm ahead: drive on\n", snapshot.Sensors.Front)
			state, err = robot.Forward(cell)
			moves++
		} else {
			fmt.Println("Wall ahead and on the right: turn left")
			state, err = robot.Left()
		}
		if err != nil {
			return err
		}
		if state == "collided" {
			fmt.Println("Bumped into a wall!")
		}
	}
}

func main() {
	// The address is the first argument, as in the other languages.
	options := flag.NewFlagSet("robot", flag.ExitOnError)
	untilCells := options.Int("until-cells", 0, "stop after this number of different cells, not at the goal")
	maxMoves := options.Int("moves", 2000, "give up after this number of moves")
	text := ""
	if len(os.Args) > 1 {
		text = os.Args[1]
		_ = options.Parse(os.Args[2:])
	}
	robot, err := NewRobot(text)
	if err == nil {
		err = followRightWall(robot, *untilCells, *maxMoves)
	}
	if err != nil {
		fmt.Fprintln(os.Stderr, err)
		os.Exit(1)
	}
}
