"""The line itself, against small servers of the test: proxies, redirects, cuts."""

import socket
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Callable, Dict, Iterator, List

import pytest
from corridor.transport import Line
from corridor.requests import Answer, Request

Serve = Callable[[Callable[[BaseHTTPRequestHandler], None]], str]


@pytest.fixture
def serve() -> Iterator[Serve]:
    servers: List[ThreadingHTTPServer] = []

    def begin(answer: Callable[[BaseHTTPRequestHandler], None]) -> str:
        class Handler(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                answer(self)

            def log_message(self, format: str, *args: object) -> None:
                return None

        server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        servers.append(server)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        return f"http://127.0.0.1:{server.server_port}"

    yield begin
    for server in servers:
        server.shutdown()
        server.server_close()


def get(url: str, timeout: float = 5.0) -> Answer:
    headers = {"Authorization": "Bearer drv_secret"}
    return Line().send(Request("GET", url, headers, None, timeout))


def plain(handler: BaseHTTPRequestHandler, status: int, headers: Dict[str, str], body: bytes) -> None:
    handler.send_response(status)
    for name, value in headers.items():
        handler.send_header(name, value)
    handler.end_headers()
    handler.wfile.write(body)


def test_the_proxy_of_the_environment_carries_the_request(
    serve: Serve, monkeypatch: pytest.MonkeyPatch
) -> None:
    proxy = serve(lambda handler: plain(handler, 200, {}, handler.path.encode()))
    monkeypatch.setenv("http_proxy", proxy)
    assert get("http://robots.invalid/r/1").body == b"http://robots.invalid/r/1"
    monkeypatch.setenv("no_proxy", "robots.invalid")
    assert get("http://robots.invalid/r/1").status == 0


def test_a_robot_on_this_machine_needs_no_proxy(
    serve: Serve, monkeypatch: pytest.MonkeyPatch
) -> None:
    here = serve(lambda handler: plain(handler, 200, {}, b"here"))
    monkeypatch.setenv("http_proxy", "http://127.0.0.1:9")
    assert get(here).body == b"here"
    assert get(here.replace("127.0.0.1", "localhost")).body == b"here"


def test_the_key_does_not_follow_a_redirect(serve: Serve) -> None:
    asked: List[str] = []
    elsewhere = serve(lambda handler: asked.append(handler.path))
    here = serve(lambda handler: plain(handler, 302, {"Location": elsewhere}, b""))
    assert get(here).status == 302
    assert asked == []


def test_when_to_come_back_is_read_where_it_is_a_number(serve: Serve) -> None:
    busy = serve(lambda handler: plain(handler, 429, {"Retry-After": "7"}, b"{}"))
    assert get(busy) == Answer(429, b"{}", retry_after=7.0)
    late = serve(lambda handler: plain(handler, 503, {"Retry-After": "Mon, 1 Jan"}, b"{}"))
    assert get(late).retry_after is None


def test_an_answer_that_is_cut_short_counts_as_lost(serve: Serve) -> None:
    cut = serve(lambda handler: plain(handler, 200, {"Content-Length": "100"}, b"{"))
    assert get(cut).status == 0


def test_an_answer_that_is_none_of_http_counts_as_lost() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        threading.Thread(target=lambda: server.accept()[0].sendall(b"SSH-2.0\r\n"), daemon=True).start()
        answer = get(f"http://127.0.0.1:{server.getsockname()[1]}")
    assert answer.status == 0 and answer.lost


def test_silence_counts_as_lost_after_a_while() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        answer = get(f"http://127.0.0.1:{server.getsockname()[1]}", timeout=0.2)
    assert answer == Answer(0, lost="no answer in time")


def test_nobody_there_is_said_in_words_without_the_key() -> None:
    answer = get("http://127.0.0.1:9")
    assert answer.status == 0
    assert "refused" in answer.lost and "secret" not in answer.lost
