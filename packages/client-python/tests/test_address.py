"""Errors of invalid addresses, which never contain the key."""

import json
from pathlib import Path
from typing import Dict

import pytest
from corridor import AddressError
from corridor.address import parse_address

KEY = "drv_AAAAAAAAAAAAAAAAAAAAAA"
#: Addresses that every client, in every language, accepts or rejects.
SHARED = json.loads(
    (Path(__file__).parents[2] / "protocol/src/testing/robot-addresses.json").read_text("utf-8")
)


@pytest.mark.parametrize("good", SHARED["good"])
def test_it_accepts_the_same_addresses_as_other_clients(good: Dict[str, str]) -> None:
    address = parse_address(good["text"])
    assert (address.origin, address.id, address.key) == (good["origin"], good["id"], good["key"])


@pytest.mark.parametrize("text", SHARED["bad"])
def test_it_rejects_the_same_addresses_as_other_clients(text: str) -> None:
    with pytest.raises(AddressError):
        parse_address(text)


def test_the_address_of_the_page_is_parsed() -> None:
    address = parse_address(f"  http://localhost:8080/r/blue-otter-42#{KEY}\n")
    assert address.api == "http://localhost:8080/api/v1/robots/blue-otter-42"
    assert address.key == KEY


def test_the_key_may_be_a_separate_argument() -> None:
    assert parse_address("https://host.example/r/abc", f" {KEY} ").key == KEY
    assert parse_address("https://host.example/r/abc#drv_of_somebody_else", KEY).key == KEY


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("", "It is empty"),
        ("localhost/r/abc#" + KEY, "begins with http://"),
        ("http://localhost:8080/r/abc", "key after the # is missing"),
        ("http://localhost:8080/r/abc#", "key after the # is missing"),
        ("http://HOST/r/ID#KEY", "HOST, ID and KEY stand for your robot's address"),
        ("http://localhost:8080/#" + KEY, "looks like http://HOST/r/ID#KEY"),
        ("http://localhost:8080/r/abc?key=" + KEY, "key after the # is missing"),
        ("http://me:secret@localhost/r/abc#" + KEY, "before the @"),
        ("http://localhost/r/abc#" + "k" * 500, "looks like http://HOST/r/ID#KEY"),
        ("http://robots..example/r/abc#" + KEY, "between http:// and /r/ is wrong"),
        ("http://" + "a" * 64 + ".example/r/abc#" + KEY, "between http:// and /r/ is wrong"),
        ("http://[::1/r/abc#" + KEY, "between http:// and /r/ is wrong"),
        ("http://localhost:99999/r/abc#" + KEY, "between http:// and /r/ is wrong"),
    ],
)
def test_an_invalid_address_is_explained(text: str, hint: str) -> None:
    with pytest.raises(AddressError, match=hint) as error:
        parse_address(text)
    assert error.value.code == "bad-address"
    assert KEY not in str(error.value)
    assert "secret" not in str(error.value)


def test_only_text_is_an_address() -> None:
    with pytest.raises(AddressError, match="text in quotes"):
        parse_address(None)  # type: ignore[arg-type]


def test_the_repr_does_not_contain_the_key() -> None:
    assert KEY not in repr(parse_address(f"http://localhost/r/abc#{KEY}"))
