import jakarta.xml.ws.BindingProvider;
import jakarta.xml.ws.handler.MessageContext;
import java.util.List;
import java.util.Map;
import robot.Action;
import robot.Command;
import robot.CommandResponse;
import robot.CorridorRobot;
import robot.GetCommands;
import robot.Robot;
import robot.RobotException;
import robot.Sense;
import robot.Sensor;
import robot.UntilCondition;

/**
 * A client that Apache CXF generates from the running service. It drives one robot with its key in
 * the address, and another with its key in a header. Prints a line for each result.
 */
public class Square {
  public static void main(String[] addresses) throws RobotException {
    Robot service = new CorridorRobot().getRobot();
    String robot = addresses[0];
    System.out.println("front " + sense(service, robot).getSensors().getFront());
    drive(service, robot, "square-1");

    Command guarded = command(robot, Action.FORWARD);
    UntilCondition near = new UntilCondition();
    near.setSensor(Sensor.FRONT);
    near.setIs("<=");
    near.setThan("60");
    guarded.getUntil().add(near);
    System.out.println("until " + service.command(guarded).getState());

    GetCommands all = new GetCommands();
    all.setRobot(robot);
    System.out.println("log " + service.getCommands(all).getCommands().size());
    try {
      Command wrong = command(robot, Action.MOVE);
      wrong.setDistance(90_000.0);
      service.command(wrong);
    } catch (RobotException fault) {
      String path = fault.getFaultInfo().getErrors().get(0).getPath();
      System.out.println("fault " + fault.getFaultInfo().getCode() + " " + path);
      System.out.println(fault.getMessage());
    }

    String[] other = addresses[1].split("#");
    Map<String, List<String>> headers = Map.of("Authorization", List.of("Bearer " + other[1]));
    ((BindingProvider) service).getRequestContext().put(MessageContext.HTTP_REQUEST_HEADERS, headers);
    drive(service, other[0], "square-2");
    System.out.println("heading " + sense(service, other[0]).getPose().getHeading());
  }

  private static robot.SenseResponse sense(Robot service, String robot) throws RobotException {
    Sense request = new Sense();
    request.setRobot(robot);
    return service.sense(request);
  }

  private static Command command(String robot, Action action) {
    Command command = new Command();
    command.setRobot(robot);
    command.setAction(action);
    command.setWait(25.0);
    return command;
  }

  /** Drives forward and turns right, four times. */
  private static void drive(Robot service, String robot, String key) throws RobotException {
    for (int side = 0; side < 4; side++) {
      Command move = command(robot, Action.MOVE);
      move.setDistance(100.0);
      move.setKey(key + "-move-" + side);
      Command turn = command(robot, Action.RIGHT_90);
      turn.setKey(key + "-turn-" + side);
      for (Command each : List.of(move, turn)) {
        CommandResponse record = service.command(each);
        System.out.println(record.getAction() + " " + record.getState());
      }
    }
  }
}
