/**
 * The texts with which a user connects a program to a robot, ready to copy. The page and the
 * documentation display the same texts.
 */
import { protocolClients, type GatewayName } from "@corridor/protocol";
import { csharp, curl, go, java, javascript, plainPython, python } from "./http-texts.ts";
import { claudeCode, cursor, vsCode } from "./mcp-texts.ts";
import { generated, micromouse, viple } from "./program-texts.ts";
import type { RobotParts } from "./robot-parts.ts";
import { rosbridge, roslib, roslibpy } from "./ros-texts.ts";
import { soapCsharp, soapJava, soapPython } from "./soap-texts.ts";

/** In the order of the list. */
export const quickstartIds = [
  "python",
  "javascript",
  "java",
  "csharp",
  "go",
  "curl",
  "plainPython",
  "generated",
  "roslibpy",
  "roslib",
  "rosbridge",
  "claudeCode",
  "vsCode",
  "cursor",
  "soapCsharp",
  "soapJava",
  "soapPython",
  "micromouse",
  "viple",
] as const;
export type QuickstartId = (typeof quickstartIds)[number];

export interface Quickstart {
  /** the same in every language; null: the reader's language has a name for it */
  name: string | null;
  /** how the list of scripts names its program, in `client` */
  client: string;
  /** the gateway that it needs; null: the API */
  gateway: GatewayName | null;
  /** where the text is saved; null: it is not a file */
  file: string | null;
  /** starts the file; null: another program reads or builds it */
  command: string | null;
  /** the oldest version of the program that runs it; null: any */
  needs: string | null;
  /** whether the text contains a key for URLs instead of the key in the address */
  hasUrlKey: boolean;
  text: (robot: RobotParts) => string;
}

const script = { gateway: null, needs: null, hasUrlKey: false } as const;
const ros = { ...script, client: protocolClients.ros, gateway: "ros" } as const;
const mcp = { ...script, client: protocolClients.mcp, gateway: "mcp", command: null } as const;
const soap = { ...script, client: protocolClients.soap, gateway: "soap" } as const;
const pythonFile = { file: "drive.py", command: "python3 drive.py" } as const;
const node = { file: "drive.mjs", command: "node drive.mjs" } as const;
const noFile = { file: null, command: null } as const;

export const quickstarts: Readonly<Record<QuickstartId, Quickstart>> = {
  python: { ...script, ...pythonFile, name: "Python", client: "Python", text: python },
  javascript: {
    ...script,
    ...node,
    name: "JavaScript",
    client: "JavaScript",
    needs: "Node 18",
    text: javascript,
  },
  java: {
    ...script,
    name: "Java",
    client: "Java",
    file: "Robot.java",
    command: "java Robot.java",
    needs: "Java 11",
    text: java,
  },
  csharp: {
    ...script,
    name: "C#",
    client: "C#",
    file: "Robot.cs",
    command: "dotnet run Robot.cs",
    needs: ".NET 10",
    text: csharp,
  },
  go: {
    ...script,
    name: "Go",
    client: "Go",
    file: "drive.go",
    command: "go run drive.go",
    needs: "Go 1.22",
    text: go,
  },
  curl: {
    ...script,
    name: "curl",
    client: "curl",
    file: "drive.sh",
    command: "sh drive.sh",
    text: curl,
  },
  plainPython: { ...script, ...pythonFile, name: null, client: "Python", text: plainPython },
  generated: { ...script, ...pythonFile, name: null, client: "Python", text: generated },
  roslibpy: { ...ros, ...pythonFile, name: "roslibpy (ROS)", text: roslibpy },
  roslib: { ...ros, ...node, name: "roslib (ROS)", needs: "Node 22", text: roslib },
  rosbridge: { ...ros, ...noFile, name: null, hasUrlKey: true, text: rosbridge },
  claudeCode: { ...mcp, name: "Claude Code (MCP)", file: null, text: claudeCode },
  vsCode: { ...mcp, name: "VS Code (MCP)", file: ".vscode/mcp.json", text: vsCode },
  cursor: { ...mcp, name: "Cursor (MCP)", file: ".cursor/mcp.json", text: cursor },
  soapCsharp: {
    ...soap,
    name: "C# (SOAP)",
    file: "Drive.cs",
    command: "dotnet run Drive.cs",
    needs: ".NET 10",
    text: soapCsharp,
  },
  soapJava: {
    ...soap,
    name: "Java (SOAP)",
    file: "src/main/java/Drive.java",
    command: null,
    text: soapJava,
  },
  soapPython: { ...soap, ...pythonFile, name: "zeep (SOAP)", text: soapPython },
  micromouse: {
    ...script,
    ...noFile,
    name: null,
    client: protocolClients.mms,
    needs: "Node 20.19",
    text: micromouse,
  },
  viple: {
    ...script,
    ...noFile,
    name: "ASU VIPLE",
    client: protocolClients.viple,
    needs: "Node 20.19",
    text: viple,
  },
};
