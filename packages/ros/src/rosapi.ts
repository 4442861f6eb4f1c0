/** The services of rosapi, by which clients list and describe topics, services and types. */
import { actionTexts, messageTexts, serviceTexts, type ServiceType } from "./interface-texts.ts";
import {
  absoluteName,
  definitionOf,
  fullName,
  fullText,
  shortName,
  withNested,
  type Field,
} from "./interfaces.ts";
import { actions } from "./goals.ts";
import type { Message } from "./read-message.ts";
import { RosError } from "./ros-error.ts";
import { robotServices, type Service, type ServiceParts } from "./services.ts";
import { topicOf, topics, VELOCITY_TOPIC, velocityTypes } from "./topics.ts";

const NODE = "/corridor";
const NO_PARAMETERS = "The robot has no parameters.";

/** Types by topic, with the one that Corridor subscribes to. */
const topicTypes = new Map<string, string>([
  [VELOCITY_TOPIC, velocityTypes[0]],
  ...Object.entries(topics).map(([name, { type }]): [string, string] => [name, type]),
]);

type Respond = (request: Message, parts: ServiceParts) => object;

function service(type: ServiceType, call: Respond): Service {
  return { type, call };
}

const textOf = (value: unknown): string => (typeof value === "string" ? value : "");
const nameOf = (value: unknown): string => absoluteName(textOf(value));
const typeOf = (value: unknown): string => shortName(textOf(value));

export const rosapi: Readonly<Record<string, Service>> = {
  topics: service("rosapi_msgs/Topics", () => listTopics()),
  topics_for_type: service("rosapi_msgs/TopicsForType", ({ type }) => ({
    topics: [...topicTypes].filter(([, each]) => each === typeOf(type)).map(([name]) => name),
  })),
  topics_and_raw_types: service("rosapi_msgs/TopicsAndRawTypes", () => ({
    ...listTopics(),
    typedefs_full_text: [...topicTypes.values()].map(fullText),
  })),
  topic_type: service("rosapi_msgs/TopicType", ({ topic }) => {
    const type = topicTypes.get(nameOf(topic));
    return { type: type === undefined ? "" : fullName(type) };
  }),
  services: service("rosapi_msgs/Services", () => ({ services: [...allServices().keys()] })),
  services_for_type: service("rosapi_msgs/ServicesForType", ({ type }) => ({
    services: [...allServices()]
      .filter(([, each]) => each.type === typeOf(type))
      .map(([name]) => name),
  })),
  service_type: service("rosapi_msgs/ServiceType", (request) => {
    const found = serviceOf(nameOf(request["service"]));
    return { type: found === null ? "" : fullName(found.type) };
  }),
  service_node: service("rosapi_msgs/ServiceNode", (request) => ({
    node: serviceOf(nameOf(request["service"])) === null ? "" : NODE,
  })),
  service_providers: service("rosapi_msgs/ServiceProviders", (request) => ({
    providers: serviceOf(nameOf(request["service"])) === null ? [] : [NODE],
  })),
  nodes: service("rosapi_msgs/Nodes", () => ({ nodes: [NODE] })),
  node_details: service("rosapi_msgs/NodeDetails", ({ node }) => {
    if (nameOf(node) !== NODE) return { subscribing: [], publishing: [], services: [] };
    return {
      subscribing: [VELOCITY_TOPIC],
      publishing: Object.keys(topics),
      services: [...allServices().keys()],
    };
  }),
  publishers: service("rosapi_msgs/Publishers", ({ topic }) => ({
    publishers: topicOf(nameOf(topic)) === null ? [] : [NODE],
  })),
  subscribers: service("rosapi_msgs/Subscribers", ({ topic }) => ({
    subscribers: nameOf(topic) === VELOCITY_TOPIC ? [NODE] : [],
  })),
  action_servers: service("rosapi_msgs/GetActionServers", () => ({
    action_servers: Object.keys(actions),
  })),
  interfaces: service("rosapi_msgs/Interfaces", () => ({
    interfaces: [messageTexts, serviceTexts, actionTexts].flatMap(Object.keys).map(fullName),
  })),
  message_details: service("rosapi_msgs/MessageDetails", ({ type }) => details(typeOf(type))),
  service_request_details: service("rosapi_msgs/ServiceRequestDetails", ({ type }) =>
    details(`${typeOf(type)}_Request`),
  ),
  service_response_details: service("rosapi_msgs/ServiceResponseDetails", ({ type }) =>
    details(`${typeOf(type)}_Response`),
  ),
  // JSON text, which clients parse: without a default, the text of an empty string.
  get_param: service("rosapi_msgs/GetParam", (request) => ({
    value: request["default_value"] || JSON.stringify(""),
  })),
  set_param: service("rosapi_msgs/SetParam", () => {
    throw new RosError(NO_PARAMETERS);
  }),
  has_param: service("rosapi_msgs/HasParam", () => ({ exists: false })),
  delete_param: service("rosapi_msgs/DeleteParam", () => {
    throw new RosError(NO_PARAMETERS);
  }),
  get_param_names: service("rosapi_msgs/GetParamNames", () => ({ names: [] })),
  get_time: service("rosapi_msgs/GetTime", (_request, { view }) => ({ time: view.stamp })),
  get_ros_version: service("rosapi_msgs/GetROSVersion", () => ({ version: 2, distro: "jazzy" })),
};

function allServices(): Map<string, Service> {
  const ofRosapi = Object.entries(rosapi).map(([name, each]): [string, Service] => [
    `/rosapi/${name}`,
    each,
  ]);
  return new Map([...Object.entries(robotServices), ...ofRosapi]);
}

/** @param name absolute */
export function serviceOf(name: string): Service | null {
  return allServices().get(name) ?? null;
}

function listTopics(): { topics: string[]; types: string[] } {
  return { topics: [...topicTypes.keys()], types: [...topicTypes.values()].map(fullName) };
}

/** The definition of a type and of all that it contains. */
function details(type: string): object {
  const typedefs = [...withNested(type)].map((each) => {
    const { fields = [], constants = [] } = definitionOf(each) ?? {};
    return {
      type: fullName(each),
      fieldnames: fields.map(({ name }) => name),
      fieldtypes: fields.map((field) => (isMessage(field) ? fullName(field.type) : field.type)),
      fieldarraylen: fields.map(({ length }) => length ?? -1),
      examples: fields.map(exampleOf),
      constnames: constants.map(({ name }) => name),
      constvalues: constants.map(({ value }) => value),
    };
  });
  return { typedefs };
}

function isMessage({ type }: Field): boolean {
  return type.includes("/");
}

/** A value as JSON text, as rosapi writes it. */
function exampleOf(field: Field): string {
  if (field.length !== null) return "[]";
  if (isMessage(field)) return "{}";
  if (field.type === "string") return "";
  if (field.type === "bool") return "False";
  return field.type.startsWith("float") ? "0.0" : "0";
}
