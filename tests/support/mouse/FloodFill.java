/** A micromouse program for mms: drives to the centre by flood fill, in half steps. */
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.util.ArrayDeque;
import java.util.Arrays;

public class FloodFill {
  private static final BufferedReader INPUT = new BufferedReader(new InputStreamReader(System.in));
  private static final int[] DX = {0, 1, 0, -1};
  private static final int[] DY = {1, 0, -1, 0};
  private static final String[] SIDES = {"n", "e", "s", "w"};

  private final int width = Integer.parseInt(ask("mazeWidth"));
  private final int height = Integer.parseInt(ask("mazeHeight"));
  private final boolean[][][] walls = new boolean[width][height][4];
  private int x;
  private int y;
  private int heading;

  private static String ask(String command) {
    System.out.println(command);
    try {
      return INPUT.readLine();
    } catch (IOException error) {
      throw new IllegalStateException(error);
    }
  }

  private static boolean isMiddle(int at, int size) {
    return at == size / 2 || at == (size - 1) / 2;
  }

  private boolean isGoal(int column, int row) {
    return isMiddle(column, width) && isMiddle(row, height);
  }

  private boolean isInside(int column, int row) {
    return column >= 0 && column < width && row >= 0 && row < height;
  }

  private void look(String command, int side) {
    if (!ask(command).equals("true")) return;
    walls[x][y][side] = true;
    int column = x + DX[side];
    int row = y + DY[side];
    if (isInside(column, row)) walls[column][row][(side + 2) % 4] = true;
    System.out.println("setWall " + x + " " + y + " " + SIDES[side]);
  }

  private int[][] distances() {
    int[][] distances = new int[width][height];
    ArrayDeque<int[]> queue = new ArrayDeque<>();
    for (int column = 0; column < width; column++) {
      Arrays.fill(distances[column], Integer.MAX_VALUE);
      for (int row = 0; row < height; row++) {
        if (!isGoal(column, row)) continue;
        distances[column][row] = 0;
        queue.add(new int[] {column, row});
      }
    }
    while (!queue.isEmpty()) {
      int[] cell = queue.remove();
      for (int side = 0; side < 4; side++) {
        int column = cell[0] + DX[side];
        int row = cell[1] + DY[side];
        if (walls[cell[0]][cell[1]][side] || !isInside(column, row)) continue;
        if (distances[column][row] != Integer.MAX_VALUE) continue;
        distances[column][row] = distances[cell[0]][cell[1]] + 1;
        queue.add(new int[] {column, row});
      }
    }
    return distances;
  }

  private void turnTo(int side) {
    int turned = (side - heading + 4) % 4;
    if (turned == 3) ask("turnLeft");
    else for (int quarter = 0; quarter < turned; quarter++) ask("turnRight");
    heading = side;
  }

  private void run() {
    while (!isGoal(x, y)) {
      look("wallFront", heading);
      look("wallRight", (heading + 1) % 4);
      look("wallLeft", (heading + 3) % 4);
      int[][] distances = distances();
      for (int side = 0; side < 4; side++) {
        int column = x + DX[side];
        int row = y + DY[side];
        if (walls[x][y][side] || !isInside(column, row)) continue;
        if (distances[column][row] != distances[x][y] - 1) continue;
        turnTo(side);
        // Before the back of the first cell was seen, its wall is not known.
        if (!ask("moveForwardHalf 2").equals("ack")) walls[x][y][side] = true;
        else {
          x = column;
          y = row;
        }
        break;
      }
    }
    System.err.println("score " + ask("getStat score"));
  }

  public static void main(String[] args) {
    new FloodFill().run();
  }
}
