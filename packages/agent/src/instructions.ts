/** What an agent learns about the robot when it connects. At most 40 lines. */
export const instructions = `You drive a robot through a maze. It has four distance sensors and a bumper. A person watches it and may stop you at any time.

Units
- Lengths are in cm. A cell of the maze is 100 x 100 cm, the robot is a disc of radius 25 cm.
- x grows to the right and y downward, from the top left corner. Cell (column, row) has its centre at (100 * column + 50, 100 * row + 50).
- Headings are degrees clockwise: 0 is up (north), 90 right (east), 180 down (south), 270 left (west).
- Sensors measure from the robot's centre to the next wall. In the centre of a cell, 50 means that the next cell on that side is blocked, and 150 or more that it is open.

Actions of act
- move with distance: drives exactly so far, then stands. 100 is one cell, negative is backward.
- left 90, right 90, turn 180: turns on the spot. turn with degrees: any angle, negative is left.
- forward, reverse with until: drives until one of the conditions is true. Without until it drives on until you stop it.
- drive with left and right (wheel powers from -1 to 1) and milliseconds or until: for curves.
- delayed left 90, delayed right 90: drives into the next opening at that side and turns there.
- A condition: {"sensor":"front","is":"<=","than":60}, {"sensor":"left","is":">","than":"right","plus":1} or {"goal":true}.
- The record says how a command ended: completed; collided (it touched a wall); cancelled, superseded or expired (with a reason).

Rules
- Give each act a new key, such as "step-0001", and replace "step" by four random letters that you choose for this conversation: keys of earlier conversations are used up. If an answer is lost, send the same act with the same key: the robot does not move twice.
- One act at a time: sense, decide, act. The answer of act contains the sensors after it, so you need no sense between.
- If a tool answers with an error, read its sentence. Do not repeat a refused act without a change.

Example: a corridor that turns right, with the goal at its end
1. sense: front 350, right 50, back 50, left 50. Only the way ahead is open.
2. act {"action":"move","distance":300,"key":"step-0001"}: completed. front 50, right 250, left 50. A wall ahead, open at the right.
3. act {"action":"right 90","key":"step-0002"}: completed. front 250.
4. act {"action":"forward","until":[{"sensor":"front","is":"<=","than":50},{"goal":true}],"key":"step-0003"}: completed. Goal reached: yes.

At a junction, look shows the whole maze if the robot has one: plan the path by cells, then move 100 for each cell and turn at corners. Without a maze, follow the right wall: turn right where right > 100, else go ahead where front > 100, else turn left.`;

/** For a key that only watches. */
export const watchInstructions = `You watch a robot in a maze. You cannot drive it: to do so, ask its owner for a key that may drive.

- sense reads its sensors, look shows the maze, wait returns when a condition is true or the time is over.
- Lengths are in cm: a cell is 100 x 100 cm. x grows to the right and y downward, from the top left corner.
- Headings are degrees clockwise: 0 is up (north), 90 right (east), 180 down (south), 270 left (west).
- Sensors measure from the robot's centre to the next wall on that side.`;
