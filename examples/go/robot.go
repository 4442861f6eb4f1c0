// Follow the right-hand wall through a maze.
//
// Run it with the robot's address, as the page shows it under Remote (keep the quotes; where it cannot
// be copied, a code gets one: see the README of the examples):
//
//	go run robot.go "http://localhost:8080/r/ID#KEY"
//
// It needs Go 1.19 or newer and nothing else. The robot keeps its right hand on the wall: where there
// is an opening on the right it goes in, else straight on, else it turns left.
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
	open = 60           // farther than this, and there is no wall in the next cell
	name = "Right wall" // what the robot's owner sees of this program

	patience     = 30 * time.Second // how long the service may stay silent
	firstPause   = 250 * time.Millisecond
	longestPause = 10 * time.Second
)

var address = regexp.MustCompile(`^(https?://[^/?#\s@]+)/r/([A-Za-z0-9_-]{1,64})#([A-Za-z0-9_-]{8,64})$`)

// Robot is a robot somewhere on the network. Every method waits until the robot has done it.
type Robot struct {
	api, key string
	http     http.Client
}

// View is what the robot sees, in cm, and where it is.
type View struct {
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

type wish map[string]any

// NewRobot takes the robot's address apart.
func NewRobot(text string) (*Robot, error) {
	parts := address.FindStringSubmatch(strings.TrimSpace(text))
	if parts == nil {
		return nil, errors.New(`This is not a robot's address. Copy the whole address from the page, and put it in "quotes": the part after the # is the key.`)
	}
	robot := &Robot{api: parts[1] + "/api/v1/robots/" + parts[2], key: parts[3]}
	robot.http.Timeout = 20 * time.Second
	// The key goes to the host of the address and to no other.
	robot.http.CheckRedirect = func(*http.Request, []*http.Request) error { return http.ErrUseLastResponse }
	return robot, nil
}

// Forward drives so many cm. It gives "completed", or "collided" if a wall was in the way.
func (robot *Robot) Forward(distance float64) (string, error) {
	return robot.command(wish{"action": "move", "distance": distance})
}

// Left turns by 90 degrees on the spot.
func (robot *Robot) Left() (string, error) { return robot.command(wish{"action": "left 90"}) }

// Right turns by 90 degrees on the spot.
func (robot *Robot) Right() (string, error) { return robot.command(wish{"action": "right 90"}) }

// Look gives what the robot sees now, never from before the end of its last command.
func (robot *Robot) Look() (View, error) {
	var view View
	err := robot.ask("GET", "/sensors?wait=10", nil, &view)
	return view, err
}

// command sends a command, waits until it has ended, and gives how.
func (robot *Robot) command(wanted wish) (string, error) {
	var now record
	if err := robot.ask("POST", "/commands", wanted, &now); err != nil {
		return "", err
	}
	for {
		switch now.State {
		case "completed", "collided":
			return now.State, nil
		case "cancelled", "superseded", "expired":
			return "", fmt.Errorf("%s was %s: %s", now.Action, now.State, now.Reason)
		}
		if err := robot.ask("GET", fmt.Sprintf("/commands/%d?wait=10", now.Seq), nil, &now); err != nil {
			return "", err
		}
	}
}

// ask makes one request, and tries again when the network or the service has a bad moment.
func (robot *Robot) ask(method, path string, wanted wish, answer any) error {
	// The key makes a retry safe: a command that arrives twice is done once.
	key := make([]byte, 16)
	if _, err := crand.Read(key); err != nil {
		return err
	}
	began := time.Now()
	for tries := 0; ; tries++ {
		mayPass, err := robot.try(method, path, wanted, hex.EncodeToString(key), time.Since(began), answer)
		if err == nil || !mayPass {
			return err
		}
		// Drawn by lot, so that a whole class does not come back in the same moment.
		limit := math.Min(float64(longestPause), float64(firstPause)*math.Pow(2, float64(tries)))
		pause := time.Duration(rand.Float64() * limit)
		if time.Since(began)+pause > patience {
			return err
		}
		time.Sleep(pause)
	}
}

func (robot *Robot) try(method, path string, wanted wish, key string, age time.Duration, answer any) (bool, error) {
	body := []byte(nil)
	if wanted != nil {
		// How old the wish is: one that comes late is not done late.
		if age >= time.Millisecond {
			wanted["age"] = age.Milliseconds()
		}
		body, _ = json.Marshal(wanted)
	}
	request, err := http.NewRequest(method, robot.api+path, bytes.NewReader(body))
	if err != nil {
		return false, err
	}
	request.Header.Set("Authorization", "Bearer "+robot.key)
	request.Header.Set("Script-Name", name)
	if wanted != nil {
		request.Header.Set("Content-Type", "application/json")
		request.Header.Set("Idempotency-Key", key)
	}
	response, err := robot.http.Do(request)
	if err != nil {
		return true, fmt.Errorf("The service does not answer: %w", err)
	}
	defer response.Body.Close()
	text, err := io.ReadAll(io.LimitReader(response.Body, 1<<20))
	if err != nil {
		return true, fmt.Errorf("The service does not answer: %w", err)
	}
	if response.StatusCode/100 == 2 {
		if json.Unmarshal(text, answer) != nil {
			return false, errors.New("What answers at this address is not a robot's host.")
		}
		return false, nil
	}
	return response.StatusCode == 429 || response.StatusCode >= 500, refusal(response.StatusCode, text)
}

// refusal is the sentence in which the service says what is wrong.
func refusal(status int, text []byte) error {
	var said problem
	if json.Unmarshal(text, &said) != nil || said.Detail == "" {
		return fmt.Errorf("The service answered with status %d.", status)
	}
	sentence := said.Detail
	for _, field := range said.Errors {
		sentence += fmt.Sprintf(" %s: found %s, expected %s.", field.Path, field.Found, field.Expected)
	}
	return errors.New(sentence)
}

// followRightWall goes on until the goal is reached, or so many different cells are visited.
func followRightWall(robot *Robot, untilCells, mostMoves int) error {
	visited := map[[2]int]bool{}
	for moves := 0; ; {
		view, err := robot.Look()
		if err != nil {
			return err
		}
		visited[[2]int{int(view.Pose.X / cell), int(view.Pose.Y / cell)}] = true
		if untilCells == 0 && view.GoalReached {
			fmt.Printf("Goal reached after %d moves.\n", moves)
			return nil
		}
		if untilCells > 0 && len(visited) >= untilCells {
			fmt.Printf("%d cells visited after %d moves.\n", len(visited), moves)
			return nil
		}
		if moves >= mostMoves {
			return fmt.Errorf("Not there after %d moves; %d cells visited.", moves, len(visited))
		}
		var how string
		if view.Sensors.Right > open {
			fmt.Printf("%.0f cm on the right: turn right and go\n", view.Sensors.Right)
			if _, err = robot.Right(); err == nil {
				how, err = robot.Forward(cell)
			}
			moves++
		} else if view.Sensors.Front > open {
			fmt.Printf("%.0f cm ahead: go on\n", view.Sensors.Front)
			how, err = robot.Forward(cell)
			moves++
		} else {
			fmt.Println("Wall ahead and on the right: turn left")
			how, err = robot.Left()
		}
		if err != nil {
			return err
		}
		if how == "collided" {
			fmt.Println("Bumped into a wall!")
		}
	}
}

func main() {
	// The address comes first, as in the other languages.
	options := flag.NewFlagSet("robot", flag.ExitOnError)
	untilCells := options.Int("until-cells", 0, "stop after so many different cells, not at the goal")
	mostMoves := options.Int("moves", 2000, "give up after so many moves")
	where := ""
	if len(os.Args) > 1 {
		where = os.Args[1]
		_ = options.Parse(os.Args[2:])
	}
	robot, err := NewRobot(where)
	if err == nil {
		err = followRightWall(robot, *untilCells, *mostMoves)
	}
	if err != nil {
		fmt.Fprintln(os.Stderr, err)
		os.Exit(1)
	}
}
