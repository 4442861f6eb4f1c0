import java.io.IOException;
import java.net.ProxySelector;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.time.Duration;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.UUID;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Follow the right-hand wall through a maze.
 *
 * <p>Run it with the robot's address, which the page shows under Remote. Keep the quotes. If you cannot
 * copy the address, use a pairing code: see the README of the examples.
 *
 * <pre>java Robot.java "http://localhost:8080/r/ID#KEY"</pre>
 *
 * <p>Requires Java 17 or newer and no libraries. The robot follows the wall on its right: it turns
 * right at an opening, else drives straight ahead, else turns left.
 */
public class Robot {
  /** One cell of the maze is 100 cm wide. */
  private static final int CELL = 100;

  /** A larger distance in cm means that the next cell is open. */
  private static final int OPEN = 60;

  private static final Pattern ADDRESS =
      Pattern.compile("(https?://[^/?#\\s@]+)/r/([A-Za-z0-9_-]{1,64})#([A-Za-z0-9_-]{8,64})");

  /** Time without an answer after which the program gives up. */
  private static final long TIMEOUT_MS = 30_000;

  private static final double FIRST_DELAY_MS = 250;
  private static final double MAX_DELAY_MS = 10_000;

  /** The name of this program on the robot's page. */
  private static final String NAME = "Right wall";

  private static final int PROXY_AUTHENTICATION_REQUIRED = 407;
  private static final int TOO_MANY_REQUESTS = 429;

  /** The robot or the service rejected a request, or did not answer. */
  public static class RobotException extends RuntimeException {
    RobotException(String message) {
      super(message);
    }
  }

  /** Sensor readings and position of the robot in cm. */
  public record Snapshot(double front, double right, double x, double y, boolean goalReached) {}

  private final String api;
  private final String key;

  // HTTP/1.1, because by default Java offers an upgrade to HTTP/2 in every request, which some
  // proxies reject. The proxy is set with -Dhttps.proxyHost.
  private final HttpClient http =
      HttpClient.newBuilder()
          .version(HttpClient.Version.HTTP_1_1)
          .connectTimeout(Duration.ofSeconds(10))
          .proxy(ProxySelector.getDefault())
          .build();

  public Robot(String address) {
    Matcher parts = ADDRESS.matcher(address.strip());
    if (!parts.matches()) {
      throw new RobotException(
          "This is not a robot's address. Copy the whole address from the page, and put it in"
              + " \"quotes\": the part after the # is the key.");
    }
    api = parts.group(1) + "/api/v1/robots/" + parts.group(2);
    key = parts.group(3);
  }

  /** Drives a distance in cm. Returns "completed", or "collided" if a wall stopped the robot. */
  public String forward(double distance) {
    return command("\"action\":\"move\",\"distance\":" + distance);
  }

  public String left() {
    return command("\"action\":\"left 90\"");
  }

  public String right() {
    return command("\"action\":\"right 90\"");
  }

  /** Returns the current snapshot, never older than the end of the last command. */
  public Snapshot snapshot() {
    String json = send("GET", "/sensors?wait=10", null);
    return new Snapshot(
        number(json, "front"),
        number(json, "right"),
        number(json, "x"),
        number(json, "y"),
        field(json, "goalReached", "(true|false)").equals("true"));
  }

  /** Sends a command, waits until it has ended, and returns its state. */
  private String command(String fields) {
    String record = send("POST", "/commands", fields);
    while (true) {
      String state = field(record, "state", "\"(\\w+)\"");
      switch (state) {
        case "completed", "collided" -> {
          return state;
        }
        case "cancelled", "superseded", "expired" ->
            throw new RobotException(
                "The command was " + state + ": " + field(record, "reason", "(null|\"[^\"]*\")"));
        default -> record = send("GET", "/commands/" + (long) number(record, "seq") + "?wait=10", null);
      }
    }
  }

  /** Sends a request to the service. Retries after network errors and server errors. */
  private String send(String method, String path, String fields) {
    // The key makes a retry safe: a command that arrives twice runs once.
    String idempotencyKey = UUID.randomUUID().toString();
    long startedAt = System.nanoTime();
    for (int attempt = 0; ; attempt++) {
      String message;
      try {
        HttpResponse<String> response = http.send(createRequest(method, path, fields, idempotencyKey, age(startedAt)), BodyHandlers.ofString());
        int status = response.statusCode();
        if (status >= 200 && status < 300) return response.body();
        message = errorMessage(status, response.body());
        if (status != TOO_MANY_REQUESTS && status < 500) throw new RobotException(message);
      } catch (IOException error) {
        message = "The service does not respond: " + error;
      } catch (InterruptedException error) {
        throw new RobotException("Stopped.");
      }
      // A random delay, so that the programs of a whole class do not retry at the same moment.
      double delay = Math.random() * Math.min(MAX_DELAY_MS, FIRST_DELAY_MS * Math.pow(2, attempt));
      if (age(startedAt) + delay > TIMEOUT_MS) throw new RobotException(message);
      sleep((long) delay);
    }
  }

  private HttpRequest createRequest(
      String method, String path, String fields, String idempotencyKey, long age) {
    HttpRequest.Builder builder =
        HttpRequest.newBuilder(URI.create(api + path))
            .timeout(Duration.ofSeconds(20))
            .header("Authorization", "Bearer " + key)
            .header("Script-Name", NAME)
            .header("User-Agent", "Java-example");
    if (fields == null) return builder.method(method, BodyPublishers.noBody()).build();
    // With the age in ms, the robot rejects a retry that arrives too late.
    String body = age == 0 ? fields : fields + ",\"age\":" + age;
    return builder
        .header("Content-Type", "application/json")
        .header("Idempotency-Key", idempotencyKey)
        .method(method, BodyPublishers.ofString("{" + body + "}"))
        .build();
  }

  private static long age(long startedAt) {
    return (System.nanoTime() - startedAt) / 1_000_000;
  }

  private static void sleep(long milliseconds) {
    try {
      Thread.sleep(milliseconds);
    } catch (InterruptedException error) {
      throw new RobotException("Stopped.");
    }
  }

  /** Returns the error message of the service. */
  private static String errorMessage(int status, String body) {
    Matcher detail = Pattern.compile("\"detail\":\\s*\"((?:[^\"\\\\]|\\\\.)*)\"").matcher(body);
    if (detail.find()) return detail.group(1).replace("\\\"", "\"");
    if (status == PROXY_AUTHENTICATION_REQUIRED) return "The network's proxy requires a user name and a password.";
    return "The service answered with status " + status + ".";
  }

  // Java has no JSON parser. Each of these field names appears only once in the responses.

  private static double number(String json, String name) {
    return Double.parseDouble(field(json, name, "(-?[0-9.eE+-]+)"));
  }

  private static String field(String json, String name, String value) {
    Matcher match = Pattern.compile("\"" + name + "\":\\s*" + value).matcher(json);
    if (match.find()) return match.group(1);
    throw new RobotException("The server at this address is not a robot's host.");
  }

  /** Drives until the goal is reached, or until {@code untilCells} different cells are visited. */
  private static void followRightWall(Robot robot, int untilCells, int maxMoves) {
    Set<String> visited = new HashSet<>();
    int moves = 0;
    while (true) {
      Snapshot snapshot = robot.snapshot();
      visited.add((int) (snapshot.x / CELL) + "," + (int) (snapshot.y / CELL));
      if (untilCells == 0 && snapshot.goalReached) {
        print("Goal reached after %d moves.", moves);
        return;
      }
      if (untilCells > 0 && visited.size() >= untilCells) {
        print("%d cells visited after %d moves.", visited.size(), moves);
        return;
      }
      if (moves >= maxMoves) {
        throw new RobotException(
            "Goal not reached after " + moves + " moves; " + visited.size() + " cells visited.");
      }
      String state;
      if (snapshot.right > OPEN) {
        print("%.0f cm on the right: turn right and drive", snapshot.right);
        robot.right();
        state = robot.forward(CELL);
        moves++;
      } else if (snapshot.front > OPEN) {
        print("%.0f cm ahead: drive on", snapshot.front);
        state = robot.forward(CELL);
        moves++;
      } else {
        print("Wall ahead and on the right: turn left");
        state = robot.left();
      }
      if (state.equals("collided")) print("Bumped into a wall!");
    }
  }

  private static void print(String format, Object... arguments) {
    System.out.println(String.format(Locale.ROOT, format, arguments));
  }

  /** Returns the value of an option: the argument after its name. */
  private static int option(String[] arguments, String name, int fallback) {
    for (int at = 1; at + 1 < arguments.length; at++) {
      if (arguments[at].equals(name)) return Integer.parseInt(arguments[at + 1]);
    }
    return fallback;
  }

  public static void main(String[] arguments) {
    try {
      Robot robot = new Robot(arguments.length == 0 ? "" : arguments[0]);
      int untilCells = option(arguments, "--until-cells", 0);
      followRightWall(robot, untilCells, option(arguments, "--moves", 2000));
    } catch (RobotException | NumberFormatException error) {
      System.err.println(error.getMessage());
      System.exit(1);
    }
  }
}
