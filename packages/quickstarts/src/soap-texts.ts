/** Programs of SOAP: they print the free distance in front of the robot and turn it left. */
import { addressOf, soapUrlOf, type RobotParts } from "./robot-parts.ts";

export function soapPython(robot: RobotParts): string {
  return `# First: pip install zeep
import zeep

robot = "${addressOf(robot)}"
service = zeep.Client("${soapUrlOf(robot)}?wsdl").service
print("front", service.Sense(robot=robot)["sensors"]["front"])
command = service.Command(robot=robot, action="left 90", wait=25)
print(command["reason"] or command["state"])
`;
}

export function soapJava(robot: RobotParts): string {
  return `// First: save pom.xml of ${robot.origin}/docs#connect in the folder that contains src, and run there:
// mvn -q compile exec:java -D wsdl="${soapUrlOf(robot)}?wsdl"
import robot.*;

public class Drive {
  public static void main(String[] words) throws RobotException {
    Robot service = new CorridorRobot().getRobot();
    Sense sense = new Sense();
    sense.setRobot("${addressOf(robot)}");
    System.out.println("front " + service.sense(sense).getSensors().getFront());
    Command command = new Command();
    command.setRobot(sense.getRobot());
    command.setAction(Action.LEFT_90);
    command.setWait(25.0);
    CommandResponse done = service.command(command);
    System.out.println(done.getReason() == null ? done.getState() : done.getReason());
  }
}
`;
}

export function soapCsharp(robot: RobotParts): string {
  return `using System;
using System.Net.Http;
using System.Text;
using System.Text.RegularExpressions;
class Drive {
    static string Call(string operation, string fields) {
        var message = "<Envelope xmlns='http://schemas.xmlsoap.org/soap/envelope/'><Body>"
            + "<" + operation + " xmlns='urn:corridor:robot:1'>"
            + "<robot>${addressOf(robot)}</robot>" + fields
            + "</" + operation + "></Body></Envelope>";
        var body = new StringContent(message, Encoding.UTF8, "text/xml");
        var answer = new HttpClient().PostAsync("${soapUrlOf(robot)}", body).Result;
        return answer.Content.ReadAsStringAsync().Result;
    }
    static string Field(string xml, string name) =>
        Regex.Match(xml, "<" + name + ">([^<]*)").Groups[1].Value;
    static void Main() {
        Console.WriteLine("front " + Field(Call("Sense", ""), "front"));
        var command = Call("Command", "<action>left 90</action><wait>25</wait>");
        var why = Field(command, "reason") + Field(command, "faultstring");
        Console.WriteLine(why == "" ? Field(command, "state") : why);
    }
}
`;
}
