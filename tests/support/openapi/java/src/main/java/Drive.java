import com.fasterxml.jackson.core.JsonProcessingException;
import corridor.ApiClient;
import corridor.ApiException;
import corridor.api.DrivingApi;
import corridor.model.CommandRecord;
import corridor.model.ForwardOrder;
import corridor.model.GoalUntilCondition;
import corridor.model.Order;
import corridor.model.Problem;
import corridor.model.SensorUntilCondition;
import corridor.model.UntilCondition;
import java.math.BigDecimal;
import java.util.List;
import java.util.Map;

/**
 * A client of OpenAPI Generator. Drives forward until a wall is near, and sends the command again, as
 * after a lost answer. Prints what it received as JSON.
 */
public class Drive {
  private static final ApiClient client = new ApiClient();
  private static String robot;

  public static void main(String[] args) throws ApiException, JsonProcessingException {
    client.updateBaseUri(args[0]);
    robot = args[1];
    client.setRequestInterceptor(request -> request.header("Authorization", "Bearer " + args[2]));

    UntilCondition wall =
        new UntilCondition(
            new SensorUntilCondition()
                .sensor(SensorUntilCondition.SensorEnum.FRONT)
                .is(SensorUntilCondition.IsEnum.LESS_THAN)
                .than(BigDecimal.valueOf(60)));
    UntilCondition goal =
        new UntilCondition(new GoalUntilCondition().goal(GoalUntilCondition.GoalEnum.TRUE));

    CommandRecord first = send(wall);
    CommandRecord again = send(wall);
    Problem conflict = refusal(goal);
    CommandRecord end =
        new DrivingApi(client)
            .followCommand(robot, first.getSeq(), BigDecimal.valueOf(25), null, null);
    System.out.println(
        client
            .getObjectMapper()
            .writeValueAsString(
                Map.of(
                    "first", first.getSeq(),
                    "again", again.getSeq(),
                    "duplicate", again.getDuplicate(),
                    "conflict", List.of(conflict.getStatus(), conflict.getType()),
                    "end", List.of(end.getState(), end.getDistance()))));
  }

  private static CommandRecord send(UntilCondition end) throws ApiException {
    Order order =
        new Order(
            new ForwardOrder().action(ForwardOrder.ActionEnum.FORWARD).until(List.of(end)));
    return new DrivingApi(client).sendCommand(robot, order, "java-openapi-1", null, null);
  }

  /** Sends an order that the relay must refuse. */
  private static Problem refusal(UntilCondition end) throws JsonProcessingException {
    try {
      throw new IllegalStateException("accepted: " + send(end));
    } catch (ApiException refused) {
      return client.getObjectMapper().readValue(refused.getResponseBody(), Problem.class);
    }
  }
}
